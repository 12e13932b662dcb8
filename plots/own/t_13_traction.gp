# Oscillating ring without and with traction on both radii: the largest error against the mesh.
tall = 1.15
load plots.'/style.gp'
load dir.'/'.name.'.var'
set multiplot layout 1,2 margins 0.09,0.985,0.38,0.92 spacing 0.06
set logscale xy
set format y '10^{%T}'
set yrange [5e-5:5e-2]
set xrange [7:72]
set xtics (8, 16, 32, 64)
set xlabel 'cells over the outer radius, N'
order(p, m) = exists(p.'_'.m) ? value(p.'_'.m) : NaN
text(p, m) = order(p, m) == order(p, m) ? minus(sprintf('%.2f', order(p, m))) : 'lost'
both(m) = ', order '.text('free', m).' and '.text('loaded', m)
runs(p, m) = (strcol('problem') eq 'ring' && strcol('method') eq m && strcol('status') eq 'ok' \
              && strstrt(strcol('params'), 'traction='.p)) ? column('cells') : NaN

set label 1 heading('(a) free of traction') at graph 0, graph 1.05
set ylabel 'largest error of all particles and steps [m]'
set key at screen 0.09, screen 0.29 left top maxrows 9 samplen 2.2 width 1
plot for [m in METHODS] csv using (runs('0', m)):'error_linf' \
         with linespoints ls style(m) title label(m).both(m), \
     0.5 / x**2 with lines ls 20 title 'N^{ −2}', 0.09 / x with lines ls 21 title 'N^{ −1}'

set label 1 heading('(b) with traction')
unset ylabel
set format y ''
unset key
plot for [m in METHODS] csv using (runs('1', m)):'error_linf' \
         with linespoints ls style(m), \
     0.5 / x**2 with lines ls 20, 0.09 / x with lines ls 21
unset multiplot
