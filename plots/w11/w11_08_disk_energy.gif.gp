# The disk through two impacts, moving: its strain energy, and where its energy is.
load plots.'/viridis.gp'
load dir.'/'.name.'.var'
set terminal gif animate delay 18 loop 0 optimize size 600,288 font 'DejaVuSans,8' background '#ffffff'
set output out
set datafile separator ','
history = dir.'/'.name.'.wls2.csv'
frames = dir.'/'.name.'.frames.csv'
frame(k) = dir.'/'.name.'.frame.'.k.'.csv'
E0 = start_wls2
set border 15 lw 1 lc rgb '#444444'
set tics nomirror out scale 0.6,0.3 textcolor rgb '#333333'
set cbrange [0:80]
stats [*:*][*:*] frames using 't' nooutput
last = STATS_records - 1
do for [k = 0:last:3] {
    stats [*:*][*:*] frames using 't' every ::k::k nooutput
    now = STATS_max
    set multiplot
    set lmargin at screen 0.06
    set rmargin at screen 0.44
    set tmargin at screen 0.92
    set bmargin at screen 0.12
    set size ratio -1
    set xrange [0:1]
    set yrange [0:1]
    set xtics 0.5
    set ytics 0.5
    set xlabel 'x [m]'
    unset ylabel
    unset key
    set label 1 sprintf('Disk, WLS2, t = %.2f s', now) at graph 0, graph 1.05
    set colorbox user origin 0.46, 0.12 size 0.015, 0.8
    set cblabel 'strain energy per volume [J/m²]' offset 0.5
    plot frame(k) using (column('surface') > 0 ? NaN : column('x')):'y':'energy' with points pt 7 ps 0.4 palette
    set lmargin at screen 0.62
    set rmargin at screen 0.97
    set size noratio
    unset colorbox
    set xrange [0:3]
    set yrange [0:1.15]
    set xtics 1
    set ytics 0.5
    set xlabel 't [s]'
    set label 1 'energy / E0'
    set key at graph 0.8, graph 0.5 right center
    set arrow 1 from now, graph 0 to now, graph 1 nohead lc rgb '#999999'
    plot history using 't':(column('total') / E0) with lines lc rgb '#222222' lw 2 title 'total', \
         '' using 't':(column('kinetic') / E0) with lines lc rgb '#555555' dt 2 lw 2 title 'kinetic', \
         '' using 't':(column('strain') / E0) with lines lc rgb '#999999' lw 2 title 'strain'
    unset arrow 1
    unset multiplot
}
