# Shell in 3D: the largest error against CPU time and against particle-steps (FEM: element-steps).
tall = 0.95
load plots.'/style.gp'
METHODS_ = 'gimp ge_gimp apic wls wls2 ge_wls'
is(m) = strcol('method') eq m && strcol('status') eq 'ok'
seconds(m) = is(m) ? column('cpu_s') : NaN
work(m) = is(m) ? column('particles') * column('steps') : NaN
fem(cfl) = is('fem') && column('cfl') == cfl
set multiplot layout 1,2 margins 0.09,0.965,0.33,0.92 spacing 0.07
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set yrange [4e-4:3e-2]
set ylabel 'largest error of all particles and steps [m]'
set label 1 heading('(a) against time') at graph 0, graph 1.05
set xlabel 'CPU time of the step loop [s]'
set key at screen 0.09, screen 0.2 left top maxrows 4 samplen 2.2 width 2
plot for [m in METHODS_] csv using (seconds(m)):'error_linf' with linespoints ls style(m) title label(m), \
     csv using (fem(.9) ? column('cpu_s') : NaN):'error_linf' with linespoints ls style('fem') title 'FEM, CFL .9, body force integrated', \
     csv using (fem(.3) ? column('cpu_s') : NaN):'error_linf' with linespoints ls style('fem') dt 2 title 'FEM, CFL .3'
unset key
unset ylabel
set format y ''
set label 1 heading('(b) against work')
set xlabel 'particle-steps; FEM: element-steps'
plot for [m in METHODS_] csv using (work(m)):'error_linf' with linespoints ls style(m), \
     csv using (fem(.9) ? column('elements') * column('steps') : NaN):'error_linf' with linespoints ls style('fem'), \
     csv using (fem(.3) ? column('elements') * column('steps') : NaN):'error_linf' with linespoints ls style('fem') dt 2
unset multiplot
