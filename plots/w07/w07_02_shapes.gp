# Trial functions and their gradients.
load plots.'/style.gp'

set xrange [-1.5:1.5]
set xtics 0.5
set xlabel '(x_p − x_i)/h'
set key top left
set multiplot layout 1,2 margins 0.1,0.98,0.13,0.9 spacing 0.12
set yrange [0:1.1]
set ytics 0.25
set ylabel 'S'
set label 1 heading('Trial functions, half width l = h/4') at graph 0, graph 1.05
plot for [m in 'mpm gimp'] csv using (only(m, 'r')):'S' with lines ls style(m) lw 2 title label(m)
set yrange [-1.25:1.25]
set ytics 0.5
set ylabel 'G h'
set label 1 heading('Their gradients')
set key top right
plot for [m in 'mpm gimp'] csv using (only(m, 'r')):'G' with lines ls style(m) lw 2 title label(m)
unset multiplot
