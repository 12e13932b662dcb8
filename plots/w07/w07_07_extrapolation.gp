# Contributions of particles to nodes: plain (solid) and along the particle's tangent (dashed).
load plots.'/style.gp'
load dir.'/'.name.'.var'

part(p) = dir.'/'.name.'.'.p.'.csv'
stats csv using 'h' nooutput
h = STATS_min
set xrange [0:1]
set yrange [0.5:4.5]
set xtics h
set format x '%.2f'
set grid xtics noytics lt 1 dt 1 lw 1.2 lc rgb '#9a9a9a'
set xlabel 'x [m]'
set ylabel 'v [m/s]'
set key top left
set label 1 heading('Extrapolated velocities, v = (1+x)², nodes at the grid lines') at graph 0, graph 1.06
plot (1 + x)**2 with lines lc rgb '#bbbbbb' lw 1.2 title 'true field', \
     part('lines') using 'x':'v':(column('node_x') - column('x')):(0) with vectors nohead \
         ls style('mpm') lw 1.2 title 'v_p carried to the nodes', \
     part('lines') using 'x':'v':(column('node_x') - column('x')):(column('extrapolated') - column('v')) \
         with vectors nohead ls style('ge_mpm') dt 2 title 'v_p extrapolated', \
     part('particles') using 'x':'vx' with points ls 22 ps 1.3 title 'particles', \
     part('mpm') using 'x':'vx' with points ls style('mpm') ps 1.6 lw 2 \
         title label('mpm').sprintf(' nodes, error %.3f inside', mpm), \
     part('ge_mpm') using 'x':'vx' with points ls style('ge_mpm') ps 1.9 lw 2 \
         title label('ge_mpm').sprintf(' nodes, error %.3f inside', ge_mpm)
