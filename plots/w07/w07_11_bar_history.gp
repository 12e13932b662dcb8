# Displacement histories at four stations.
load plots.'/style.gp'
load dir.'/'.name.'.var'

stations = dir.'/'.name.'.stations.csv'
set xrange [0:50]
set yrange [-12:14.5]
set ytics 5
set xlabel 't [ms]'
set ylabel 'u [mm]'
set key top right maxrows 2 width 1
set label 1 heading('Suddenly stopped bar, h = 1/40: displacement at four stations') at graph 0, graph 1.06
set label 2 sprintf('tip: amplitude %.3f v_0L/c, period %.3f × 4L/c', W07_11_amplitude, W07_11_period) \
    at graph 0.03, graph 0.06
array SHADE[4] = ['#c4c4c4', '#999999', '#666666', '#222222']
plot for [s = 1:4] stations using (1e3 * column('t')):(1e3 * column('u_exact')) every 4::(s - 1) \
         with lines lc rgb SHADE[s] lw 1.8 title sprintf('exact, X = %g m', s / 4.0), \
     stations using (1e3 * column('t')):(1e3 * column('u')) with points ls style('gimp') ps 0.6 \
         title label('gimp')
