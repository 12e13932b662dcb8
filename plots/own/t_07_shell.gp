# Oscillating ring and shell: the largest error against the mesh, in two and in three dimensions.
tall = 1.15
load plots.'/style.gp'
load dir.'/'.name.'.var'
set multiplot layout 1,2 margins 0.09,0.985,0.38,0.92 spacing 0.06
set logscale xy
set format y '10^{%T}'
set yrange [2e-4:5e-2]
set xrange [7:36]
set xtics (8, 12, 16, 24, 32)
set xlabel 'cells over the outer radius, N'
order(p, m) = exists(p.'_'.m) ? value(p.'_'.m) : NaN
text(p, m) = order(p, m) == order(p, m) ? minus(sprintf('%.2f', order(p, m))) : 'lost'
both(m) = ', order '.text('ring', m).' and '.text('shell', m)
runs(p, m) = (strcol('problem') eq p && strcol('method') eq m && strcol('status') eq 'ok' \
              && !strstrt(strcol('params'), 'body=elements')) ? column('cells') : NaN
integrated(p) = (strcol('problem') eq p && strstrt(strcol('params'), 'body=elements')) ? column('cells') : NaN
known(m) = exists('shell_'.m)

set label 1 heading('(a) ring, 2D') at graph 0, graph 1.05
set ylabel 'largest error of all particles and steps [m]'
set key at screen 0.09, screen 0.29 left top maxrows 9 samplen 2.2 width 1
plot for [m in METHODS] known(m) ? csv : '/dev/null' using (runs('ring', m)):'error_linf' \
         with linespoints ls style(m) title label(m).both(m), \
     NaN with linespoints ls style('fem') dt 2 title 'FEM, body force integrated', \
     0.5 / x**2 with lines ls 20 title 'N^{ −2}', 0.09 / x with lines ls 21 title 'N^{ −1}'

set label 1 heading('(b) shell, 3D')
unset ylabel
set format y ''
unset key
plot for [m in METHODS] known(m) ? csv : '/dev/null' using (runs('shell', m)):'error_linf' \
         with linespoints ls style(m), \
     csv using (integrated('shell')):'error_linf' with linespoints ls style('fem') dt 2, \
     0.5 / x**2 with lines ls 20, 0.09 / x with lines ls 21
unset multiplot
