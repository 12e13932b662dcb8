# A sweep of run options: one curve for each combination of all but one of them.
load plots.'/style.gp'
load dir.'/'.name.'.var'
orders_ = dir.'/'.name.'.orders.csv'
curves_ = dir.'/'.name.'.curves.csv'
stats orders_ using 'series' nooutput
curves = STATS_max + 1
array TITLE[curves]
array ORDER[curves]
stats orders_ using (TITLE[int(column('series')) + 1] = strcol('curve'), \
                     ORDER[int(column('series')) + 1] = strcol('order'), 1) nooutput
set datafile missing NaN
set logscale y
set format y '10^{%T}'
set xlabel x_name noenhanced
set ylabel y_name noenhanced
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
if (x_log) { set logscale x }
set autoscale xfix
if (x_tics ne '') { eval 'set xtics ('.x_tics.')' }
set key below maxcols 2 noenhanced
set label 1 'Sweep of '.problem.': '.y_name.' over '.x_name at graph 0, graph 1.06 noenhanced \
    font 'DejaVu Sans Bold,'.(fmt eq 'png' ? 18 : 12)
says(k) = TITLE[k].(strlen(ORDER[k]) ? (x_name eq 'cells' ? ', order ' : ', slope ').minus(sprintf('%.2f', real(ORDER[k]))) : '')
of(k) = int(column('series')) == k - 1 && (strcol('status') eq 'ok' || strcol('status') eq 'energy_growth') ? column(2) : NaN
lost(k) = int(column('series')) == k - 1 && strcol('status') ne 'ok' && strcol('status') ne 'energy_growth' ? column(2) : NaN
plot for [k = 1:curves] curves_ using (of(k)):3 with linespoints ls 1 + (k - 1) % 10 dt 1 + (k - 1) / 10 title says(k)
