# Energies of the disk through two impacts: WLS and GIMP, and the total of every method.
tall = 1.35
load plots.'/style.gp'
load dir.'/'.name.'.var'
small = fmt eq 'png' ? ',15' : ',10'
file(m) = dir.'/'.name.'.'.m.'.csv'
first(m) = value('start_'.m) # total at t = 0
back(m) = exists('back_'.m) ? value('back_'.m) : NaN
share(x) = x == x ? sprintf(', %.1f %%', 100 * x) : ', lost'

set multiplot
set xrange [0:3]
set xtics 0.5
set xlabel 't [s]'
set yrange [0:1.1]
set ytics 0.2
do for [k = 1:2] {
    m = word('wls gimp', k)
    E0 = first(m)
    set lmargin at screen (k == 1 ? 0.1 : 0.56)
    set rmargin at screen (k == 1 ? 0.5 : 0.97)
    set tmargin at screen 0.95
    set bmargin at screen 0.58
    set label 1 heading((k == 1 ? '(a) ' : '(b) ').label(m)) at graph 0, graph 1.05
    set ylabel k == 1 ? 'energy / E_0' : ''
    set key at graph 0.78, graph 0.5 right center
    plot file(m) using 't':(column('total') / E0) with lines lc rgb '#222222' lw 2 title 'total', \
         '' using 't':(column('kinetic') / E0) with lines lc rgb '#555555' dt 2 lw 2 title 'kinetic', \
         '' using 't':(column('strain') / E0) with lines lc rgb '#999999' lw 2 title 'strain'
}
set lmargin at screen 0.1
set rmargin at screen 0.70
set tmargin at screen 0.46
set bmargin at screen 0.09
set label 1 heading('(c) total energy, every method')
set ylabel 'total energy / E_0' offset 1
set yrange [0.9:1.08]
set ytics 0.05
set label 2 'floor' at 0.62, 0.907 center
set label 3 'right wall' at 2.7, 0.907 center
set arrow 1 from 2.3, graph 0 to 2.3, graph 1 nohead ls 21
set key at screen 0.71, screen 0.475 left top maxcols 1 spacing 0.95 samplen 1.8 font small title 'left of E_0 at t = 2.3' left
plot for [m in METHODS] exists('back_'.m) ? file(m) : '/dev/null' using 't':(column('total') / first(m)) \
         with lines ls style(m) lw 2 title label(m).share(back(m)), \
     for [m in 'wls wls2 gimp'] exists('back_'.m) ? file(m.'_unilateral') : '/dev/null' \
         using 't':(column('total') / first(m)) with lines ls style(m) dt 2 title label(m).', wall lets go'
unset multiplot
