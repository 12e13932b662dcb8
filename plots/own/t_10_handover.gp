# Hand-over from WLS2 to GIMP: the largest error against time, for the ring and the vortex.
tall = 0.8
load plots.'/style.gp'
set multiplot layout 1,2 margins 0.115,0.985,0.2,0.9 spacing 0.125
part(p) = dir.'/'.name.'.'.p.'.csv'
set logscale y
set format y '10^{%T}'
set key right bottom samplen 1
set xlabel 'time t [s]'
set yrange [1e-5:1]
set ylabel 'error at that time [m]'
set label 1 heading('(a) ring') at graph 0, graph 1.05
plot part('ring_wls2') using 't':'error_linf' with lines ls style('wls2') title 'WLS2', \
     part('ring_gimp') using 't':'error_linf' with lines ls style('gimp') title 'GIMP, radial layout', \
     for [k=0:4] part('ring_'.k) using 't':'error_linf' with lines lc rgb '#888888' dt 2 \
         title (k ? '' : 'WLS2, then GIMP at five times')
set label 1 heading('(b) vortex, G = 1')
plot part('vortex_wls2') using 't':'error_linf' with lines ls style('wls2') title 'WLS2 (inverts)', \
     part('vortex_gimp') using 't':'error_linf' with lines ls style('gimp') title 'GIMP, domain=undeformed', \
     for [k=0:2] part('vortex_'.k) using 't':'error_linf' with lines lc rgb '#888888' dt 2 \
         title (k ? '' : 'WLS2, then GIMP at .05, .1, .15')
unset multiplot
