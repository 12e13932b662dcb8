# WLS on the ring, one reading changed at a time: from the published method on, and from the cured one back.
load plots.'/style.gp'
load dir.'/'.name.'.var'
set multiplot layout 1,3 margins 0.085,0.99,0.38,0.92 spacing 0.085
set logscale xy
set format y '10^{%T}'
set yrange [5e-6:3e-2]
set xrange [7:300]
set xtics (8, 16, 32, 64, 128, 256)
set xlabel 'cells over the outer radius, N'
set ylabel 'largest error of all particles and steps [m]'
has(s) = strstrt(strcol('params'), s) > 0
# how many settings differ from those of the method
off(d, q, s, t, r) = !has('distance='.d) + !has('quadrature='.q) + !has('spurious_velocity='.s) + !has('trigger='.t) \
                     + !has('return='.r) + !has('stress=linear') + !has('average=weighted')
from_wls(x) = strcol('method') eq 'wls' && !has('steps=1') ? off('weighted_mean', 'centroid', 'constant', '0.12', 'linear') : -1
from_wls2(x) = strcol('method') eq 'wls2' && !has('steps=1') ? off('normals', 'exact', 'extrapolate', '0.25', 'linear') : -1
one(count, s) = count == 1 && has(s) ? column('cells') : NaN

set label 1 heading('(a) WLS, one change') at graph 0, graph 1.05
set key at screen 0.05, screen 0.265 left top maxrows 7 samplen 2.2 width 1
plot csv using (from_wls(0) == 0 ? column('cells') : NaN):'error_linf' with linespoints ls style('wls') lw 2.2 title label('wls'), \
     csv using (one(from_wls(0), 'distance=normals')):'error_linf' with linespoints lc rgb VARIANT[3] lw 1.6 pt 4 ps 0.8 title 'distance by normals', \
     csv using (one(from_wls(0), 'quadrature=exact')):'error_linf' with linespoints lc rgb VARIANT[2] lw 1.6 pt 7 ps 0.8 title 'exact cut cells', \
     csv using (one(from_wls(0), 'trigger=0.25')):'error_linf' with linespoints lc rgb VARIANT[4] lw 1.6 pt 9 ps 0.8 title 'trigger weight 0.25', \
     csv using (one(from_wls(0), 'spurious_velocity=extrapolate')):'error_linf' with linespoints lc rgb VARIANT[1] lw 1.6 pt 13 ps 0.8 title 'extrapolated velocities', \
     csv using (one(from_wls(0), 'stress=c0')):'error_linf' with linespoints lc rgb VARIANT[5] lw 1.6 pt 12 ps 0.8 title 'no slopes', \
     0.5 / x**2 with lines ls 20 title 'N^{ −2}'

set label 1 heading('(b) WLS2, one cure less')
unset ylabel
set format y ''
set key at screen 0.39, screen 0.265 left top maxrows 7
plot csv using (from_wls2(0) == 0 ? column('cells') : NaN):'error_linf' with linespoints ls style('wls2') lw 2.2 title label('wls2'), \
     csv using (one(from_wls2(0), 'distance=weighted_mean')):'error_linf' with linespoints lc rgb VARIANT[3] lw 1.6 pt 4 ps 0.8 title 'distance to the mean', \
     csv using (one(from_wls2(0), 'quadrature=centroid')):'error_linf' with linespoints lc rgb VARIANT[2] lw 1.6 pt 7 ps 0.8 title 'one point in cut cells', \
     csv using (one(from_wls2(0), 'return=spline')):'error_linf' with linespoints lc rgb VARIANT[1] lw 1.6 pt 6 ps 0.8 dt 2 title 'return by spline', \
     0.5 / x**2 with lines ls 20 title 'N^{ −2}'

set label 1 heading('(c) cut points')
set ylabel 'distance from the surface [m]' offset 0.5
set format y '10^{%T}'
set yrange [2e-10:3e-2]
set key at screen 0.73, screen 0.265 left top maxrows 7
cuts = dir.'/'.name.'.cuts.csv'
plot for [m in 'wls wls2 ge_wls'] cuts using (strcol('method') eq m ? column('cells') : NaN):'error' with linespoints ls style(m) title label(m), \
     0.2 / x**2 with lines ls 20 title '0.2 h^{ 2} / m'
unset multiplot
