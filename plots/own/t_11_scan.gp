# Bodies from images: the ring against the pixel, a porous sample squeezed between platens.
tall = 1.25
load plots.'/style.gp'
load plots.'/viridis.gp'
part(p) = dir.'/'.name.'.'.p.'.csv'
runs(m, e) = (strcol('problem') eq 'scan' && strcol('method') eq m && strstrt(strcol('params'), 'load=radial') \
              && strstrt(strcol('params'), 'steps=') == 0 && strstrt(strcol('params'), 'edge='.e)) ? pixels(strcol('params')) : NaN
pixels(s) = int(first(s[strstrt(s, 'pixels=') + 7:]))
first(s) = s[1:strstrt(s, ';') - 1]
stats csv using ((strcol('problem') eq 'ring' && strcol('method') eq 'wls2') ? column('error_linf') : NaN) nooutput
exact = STATS_max
set multiplot
set lmargin screen 0.1; set rmargin screen 0.47; set bmargin screen 0.6; set tmargin screen 0.94
set logscale xy
set format y '10^{%T}'
set xtics (64, 128, 256, 512, 1024)
set xrange [50:1300]
set yrange [1e-9:8e-3]
set xlabel 'pixels of the image, 1.1 m wide' offset 0,0.4
set ylabel 'error [m]'
set key at graph 0.03, graph 0.4 left top samplen 2 spacing 1.05
set label 1 heading('(a) ring, N = 32') at graph 0, graph 1.05
plot csv using (runs('wls2', 'halfway')):'error_linf' with linespoints ls style('wls2') title 'WLS2, halfway', \
     '' using (runs('wls2', 'grey')):'error_linf' with linespoints ls style('wls2') dt 2 title 'WLS2, grey', \
     exact with lines ls 20 title 'exact geometry', \
     part('surface') using (strcol('edge') eq 'halfway' ? column('pixels') : NaN):'away' \
         with linespoints lc rgb '#888888' pt 6 title 'surface points, halfway', \
     '' using (strcol('edge') eq 'grey' ? column('pixels') : NaN):'away' \
         with linespoints lc rgb '#888888' pt 6 dt 2 title 'surface points, grey'
unset logscale
set lmargin screen 0.58; set rmargin screen 0.97
set format y '%h'
set xtics auto
set xrange [0:10]
set yrange [0:*]
set xlabel 'shortening [%]'
set ylabel 'nominal stress [Pa]'
set key at graph 0.03, graph 0.98 left top
set label 1 heading('(b) porous sample')
plot for [m in 'gimp ge_gimp wls2 ge_wls'] part('stress') \
     using (100 * only(m, 'strain')):'stress' with lines ls style(m) title label(m)
set size ratio -1
set xrange [-0.06:1.06]
set yrange [0.02:0.98]
set cbrange [0:3000]
set xtics 0.5
set ytics 0.5
set border 15
set grid noxtics noytics
unset key
unset colorbox
set ylabel 'y [m]' offset 1
set xlabel 'x [m]'
do for [k = 1:2] {
    m = word('gimp wls2', k)
    set lmargin screen (k == 1 ? 0.08 : 0.49); set rmargin screen (k == 1 ? 0.44 : 0.85)
    set bmargin screen 0.07; set tmargin screen 0.46
    if (k == 2) {
        unset ylabel
        set colorbox user origin 0.862, 0.1 size 0.018, 0.34
        set cblabel 'von Mises stress [Pa]' offset 1.2
    }
    set label 1 heading((k == 1 ? '(c) ' : '(d) ').label(m).', 10 %') at graph 0, graph 1.05
    plot part('body_'.m) using (column('surface') > 0 ? NaN : column('x')):'y':'von_mises' \
         with points pt 7 ps 0.22 palette
}
unset multiplot
