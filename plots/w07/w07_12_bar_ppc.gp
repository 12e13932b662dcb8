# Error after one period against particles per cell, and when runs are lost.
load plots.'/style.gp'
load dir.'/'.name.'.var'

METHODS_HERE = 'mpm gimp ge_mpm ge_gimp'
T = 0.04 # the period [s], to choose the runs that last for one
ended(s) = s ne 'ok' && s ne 'energy_growth'
in_sweep(m) = strcol('method') eq m && column('cells') == 40 && abs(column('t_end') - T) < 1e-9
kept(m) = in_sweep(m) && !ended(strcol('status')) ? column('ppc') : NaN
gone(m) = in_sweep(m) && ended(strcol('status')) ? column('ppc') : NaN
middle(m) = m eq 'mpm' ? mpm_median : m eq 'gimp' ? W07_12_gimp_median : m eq 'ge_gimp' ? W07_12_ge_gimp_median : NaN
says(m) = middle(m) > 0 ? sprintf(', median %.4f', middle(m)) : ''

set multiplot
set lmargin at screen 0.1
set rmargin at screen 0.62
set bmargin at screen 0.12
set tmargin at screen 0.9
set logscale xy
set xrange [0.95:10.5]
set yrange [0.025:3]
set xtics (1, 2, 3, 4, 5, 6, 8, 10)
set ytics (0.03, 0.05, 0.1, 0.2, 0.5, 1)
set xlabel 'particles per cell, PPC'
set ylabel 'largest error over one period / (v_0 L/c)'
set label 1 heading('Suddenly stopped bar, h = 1/40, one period') at graph 0, graph 1.05
set key at graph 0.99, graph 0.9 right top
top(k) = 2.8 / 1.1**k
plot for [m in METHODS_HERE] csv using (kept(m)):'error_linf' with linespoints ls style(m) \
         title label(m).says(m), \
     for [k = 1:4] csv using (gone(word(METHODS_HERE, k))):(top(k)) with points \
         ls style(word(METHODS_HERE, k)) pt 2 ps 1 lw 2 notitle, \
     NaN with points pt 2 ps 1 lw 2 lc rgb '#444444' title 'lost before the end (top edge)'

set lmargin at screen 0.72
set rmargin at screen 0.98
unset logscale
set xrange [0:5]
set yrange [-2:47]
set xtics 1
set ytics 10
set xlabel 't/T'
set ylabel 'runs lost' offset 1
stats dir.'/'.name.'.census.csv' using 'runs' nooutput
set label 1 heading(sprintf('Runs lost, of %d', STATS_max))
unset key
set label 2 'MPM' at 3.9, W07_12_mpm_lost_5 - 1.5 front
set label 3 'GIMP, GE-GIMP: none' at 1.35, 1.5 front
set label 4 'GE-MPM' at 3.2, 42.5 front
plot for [m in METHODS_HERE] dir.'/'.name.'.census.csv' using (only(m, 'periods')):'lost' with lines \
         ls style(m) lw (m eq 'gimp' ? 6 : 2.4)
unset multiplot
