# Whole shells at random offsets and turns: the largest error of each run, by method.
tall = 0.7
load plots.'/style.gp'
set logscale y
set yrange [4e-3:2.5e-2]
set ytics (0.004, 0.006, 0.01, 0.015, 0.02)
set xrange [0.5:6.5]
set xtics 1
set xlabel 'place: a random offset and turn of the whole shell'
set ylabel 'largest error of all particles and steps [m]'
set key outside right top
whole(m) = strcol('method') eq m && strstrt(strcol('params'), 'sector=full') && strcol('status') ne 'inverted' ? column('error_linf') : NaN
n = 0
set label 1 heading('shell, N = 8, one period') at graph 0, graph 1.06
plot for [m in 'wls wls2 ge_wls'] n = 0 csv using (n = whole(m) == whole(m) ? n + 1 : n):(whole(m)) \
         with points ls style(m) ps 1.2 title label(m)
