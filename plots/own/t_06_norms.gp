# One run, six norms: errors on one mesh, and the orders that each norm reports.
tall = 1.9
load plots.'/style.gp'
norms_ = dir.'/'.name.'.norms.csv'
same_ = dir.'/'.name.'.same.csv'
set datafile missing NaN
set multiplot layout 3,2 margins 0.1,0.985,0.125,0.96 spacing 0.1,0.105
of(p, m) = strcol('problem') eq p && strcol('method') eq m ? column('norm') : NaN
set xrange [-0.4:5.4]
set xtics ('largest' 0, 'rms' 1, 'mean' 2, 'largest' 3, 'rms' 4, 'mean' 5)
set label 2 'over all time' at 1, graph -0.16 center
set label 3 'at the end' at 4, graph -0.16 center
set arrow 1 from 2.5, graph 0 to 2.5, graph 1 nohead ls 21
set key off

set logscale y
set yrange [5e-5:5e-3]
set format y '10^{%T}'
set label 1 heading('Ring, N = 32: error [m]') at graph 0, graph 1.06
plot for [m in 'gimp ge_gimp fem'] norms_ using (of('ring', m)):'error' with linespoints ls style(m) dt 3 ps 1.1

set label 1 heading('Ring: error of GIMP over that of FEM')
unset arrow 1
unset label 2
unset label 3
set xrange [7:75]
set logscale x
set xtics (8, 16, 32, 64)
set xlabel 'N'
set yrange [0.5:300]
set ytics (0.5, 1, 2, 5, 10, 20, 50, 100)
set format y '%g'
set key top left
plot same_ using (strcol('method') eq 'gimp' ? column('cells') : NaN):(column('all') / column('fem_all')) \
         with linespoints ls style('gimp') title 'largest, all points of each', \
     same_ using (strcol('method') eq 'gimp' ? column('cells') : NaN):(column('linf') / column('fem_linf')) \
         with linespoints ls style('gimp') dt 2 pt 6 title 'largest, same points inside', \
     same_ using (strcol('method') eq 'gimp' ? column('cells') : NaN):(column('l1') / column('fem_l1')) \
         with linespoints ls style('gimp') dt 3 pt 4 title 'mean, same points inside', \
     1 with lines ls 20 notitle

unset logscale
unset xlabel
set key off
set xrange [-0.4:5.4]
set xtics ('largest' 0, 'rms' 1, 'mean' 2, 'largest' 3, 'rms' 4, 'mean' 5)
set ytics autofreq
set format y '%.1f'
set yrange [0:2.4]
set arrow 1 from 2.5, graph 0 to 2.5, graph 1 nohead ls 21
set label 2 'over all time' at 1, graph -0.16 center
set label 3 'at the end' at 4, graph -0.16 center
set label 1 heading('Ring: order in space')
set key at screen 0.1, screen 0.04 left top maxrows 1
plot for [m in 'gimp ge_gimp fem'] norms_ using (of('ring', m)):'order' with linespoints ls style(m) dt 3 ps 1.1 title label(m)
set key off
set label 1 heading('Sine bar, exact law: order in space')
plot for [m in 'gimp ge_gimp'] norms_ using (of('sine_bar', m)):'order' with linespoints ls style(m) dt 3 ps 1.1
set label 1 heading('Axis-aligned displacement: order in space')
plot for [m in 'gimp ge_gimp fem'] norms_ using (of('axis_mms', m)):'order' with linespoints ls style(m) dt 3 ps 1.1
set label 1 heading('Vortex, fitted points: order in space')
plot for [m in 'gimp ge_gimp fem'] norms_ using (of('vortex', m)):'order' with linespoints ls style(m) dt 3 ps 1.1
unset multiplot
