# GE-WLS beside FEM: mesh size; time steps; the disk's energy.
load plots.'/style.gp'
load dir.'/'.name.'.var'
set multiplot layout 1,3 margins 0.085,0.99,0.38,0.92 spacing 0.095
shares = dir.'/'.name.'.shares.csv'
set logscale xy
set xrange [7:150]
set xtics (8, 16, 32, 64, 128)
set yrange [0.1:4]
set ytics (0.1, 0.2, 0.5, 1, 2, 4)
set xlabel 'cells over the outer radius, N'
set ylabel "largest error over FEM's" offset 1.8
set label 1 heading('(a) ring, mesh size') at graph 0, graph 1.05
set key at screen 0.05, screen 0.265 left top maxrows 6 samplen 2.2 width 1
of(p, m) = strcol('problem') eq p && strcol('method') eq m ? column('cells') : NaN
plot for [m in 'ge_wls wls2'] shares using (of('ring', m)):'share' with linespoints ls style(m) title label(m), \
     for [m in 'ge_wls wls2'] shares using (of('axis_mms', m)):'share' with linespoints ls style(m) dt 2 title label(m).', no free surface', \
     1 with lines ls 20 title 'FEM'

set label 1 heading('(b) ring, time steps')
set key at screen 0.54, screen 0.265 left top maxrows 7
set xrange [0.04:1]
set xtics (0.05, 0.1, 0.2, 0.4, 0.8)
set yrange [1e-4:1e-3]
set ytics (1e-4, 2e-4, 5e-4, 1e-3)
set format y '%.0e'
set xlabel 'CFL'
set ylabel 'largest error [m]' offset 1
at(m) = strcol('problem') eq 'ring' && strcol('method') eq m && column('cells') == 32 && column('t_end') < 0.021 \
        && (m eq 'fem' || column('ppc_asked') == 4) && strstrt(strcol('params'), 'sector=full') == 0 \
        && strcol('status') eq 'ok' ? column('cfl') : NaN
plot for [m in 'ge_wls wls2 fem'] csv using (at(m)):'error_linf' smooth unique with linespoints ls style(m) title label(m)

unset logscale
set ytics auto
set label 1 heading('(c) disk: energy')
set key at screen 0.73, screen 0.265 left top maxrows 7
set xrange [0:4]
set xtics 1
set yrange [0.9:1.05]
set format y '%.2f'
set xlabel 'time [s]'
set ylabel 'E/E_0' offset 0.5
E0 = 0
first(e) = (E0 = $0 == 0 ? e : E0, e / E0)
plot dir.'/'.name.'.disk.csv' using 't':(first(column('total'))) with lines ls style('ge_wls') lw 2.2 title label('ge_wls')
unset multiplot
