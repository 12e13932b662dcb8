# GE-WLS beside FEM: each part removed; time steps; the disk's energy.
load plots.'/style.gp'
load dir.'/'.name.'.var'
set multiplot layout 1,3 margins 0.085,0.99,0.38,0.92 spacing 0.095
shares = dir.'/'.name.'.shares.csv'
set logscale xy
set xrange [7:150]
set xtics (8, 16, 32, 64, 128)
set yrange [0.5:4]
set ytics (0.5, 0.7, 1, 1.5, 2, 3, 4)
set xlabel 'cells over the outer radius, N'
set ylabel "largest error over FEM's" offset 0.5
set label 1 heading('(a) ring, one part less') at graph 0, graph 1.05
set key at screen 0.05, screen 0.265 left top maxrows 6 samplen 2.2 width 1
of(p, w) = strcol('problem') eq p && strcol('what') eq w ? column('cells') : NaN
plot shares using (of('ring', 'ge_wls')):'share' with linespoints ls style('ge_wls') lw 2.2 title label('ge_wls'), \
     shares using (of('ring', 'mass')):'share' with linespoints ls 1 title 'lumped mass', \
     shares using (of('ring', 'hermite')):'share' with linespoints ls 2 title 'no gradients', \
     shares using (of('ring', 'distance')):'share' with linespoints ls 3 title 'straight cuts', \
     shares using (of('ring', 'return')):'share' with linespoints ls 4 title 'linear return', \
     shares using (of('ring', 'velocity')):'share' with linespoints ls 5 title 'plain velocity', \
     shares using (of('ring', 'motion')):'share' with linespoints ls 1 dt 2 title 'lagged motion', \
     shares using (of('ring', 'average')):'share' with linespoints ls 2 dt 2 title 'not folded', \
     shares using (of('ring', 'wls2')):'share' with linespoints ls style('wls2') title label('wls2'), \
     1 with lines ls 20 title 'FEM'

set label 1 heading('(b) ring, time steps')
set key at screen 0.54, screen 0.265 left top maxrows 7
set xrange [0.04:1]
set xtics (0.05, 0.1, 0.2, 0.4, 0.8)
set yrange [1e-4:1e-3]
set ytics (1e-4, 2e-4, 5e-4, 1e-3)
set format y '%.0e'
set xlabel 'CFL'
set ylabel 'largest error [m]' offset 0.5
at(m) = strcol('problem') eq 'ring' && strcol('method') eq m && column('cells') == 32 && column('t_end') < 0.021 \
        && (m eq 'fem' || column('ppc_asked') == 4) && strstrt(strcol('params'), 'sector=full') == 0 \
        && (m ne 'ge_wls' || (strstrt(strcol('params'), 'mass=corrected') && strstrt(strcol('params'), 'hermite=1000;') \
        && strstrt(strcol('params'), 'distance=curved') && strstrt(strcol('params'), 'return=spline') \
        && strstrt(strcol('params'), 'average=folded') && strstrt(strcol('params'), 'motion=consistent') \
        && strstrt(strcol('params'), 'velocity=corrected'))) \
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
disk(k) = dir.'/'.name.'.disk.'.k.'.csv'
E0 = 0
first(e) = (E0 = $0 == 0 ? e : E0, e / E0)
plot disk(-1) using 't':(first(column('total'))) with lines ls style('ge_wls') lw 2.2 title label('ge_wls'), \
     disk(3) using 't':(first(column('total'))) with lines ls 1 title 'lumped mass', \
     disk(2) using 't':(first(column('total'))) with lines ls 2 title 'no gradients', \
     disk(1) using 't':(first(column('total'))) with lines ls 3 title 'straight cuts', \
     disk(5) using 't':(first(column('total'))) with lines ls 4 title 'linear return'
unset multiplot
