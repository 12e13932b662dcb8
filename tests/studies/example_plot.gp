# t_90_free_bar.gp: largest error against the cell size.
load plots.'/style.gp'
load dir.'/'.name.'.var'

set logscale xy
set xlabel 'h [m]'
set ylabel 'largest error / A'
set label 1 heading(sprintf('Free bar: GIMP of order %.2f', T_90_order)) at graph 0, graph 1.06
plot for [m in 'gimp ge_gimp'] csv using (only(m, 'h')):'error_linf' with linespoints ls style(m) title label(m)
