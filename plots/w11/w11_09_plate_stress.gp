# Von Mises stress on the particles of the plate with a hole at three times, two methods.
tall = 0.88
load plots.'/style.gp'
load plots.'/viridis.gp'
set multiplot layout 2,3 margins 0.08,0.865,0.13,0.93 spacing 0.03,0.1
set size ratio -1
set xrange [0:1.42]
set yrange [0:1.05]
set xtics 0.5
set ytics 0.5
set border 15
set grid noxtics noytics
unset key
unset colorbox
set cbrange [0:130]
file(m, t) = dir.'/'.name.'.'.m.'.'.t.'.csv'
do for [row = 0:1] {
    m = word('wls2 gimp', row + 1)
    do for [k = 1:3] {
        t = word('0 464 696', k)
        set label 1 heading(label(m).', t = '.t.' µs') at graph 0, graph 1.08
        set format y k == 1 ? '%g' : ''
        set format x row ? '%g' : ''
        set xlabel row ? 'x [m]' : ''
        set ylabel (k == 1 ? 'y [m]' : '') offset 1
        if (row == 1 && k == 3) {
            set colorbox user origin 0.885, 0.13 size 0.018, 0.8
            set cblabel 'von Mises stress [GPa]' offset 0.5
        }
        plot file(m, t) using (column('surface') > 0 ? NaN : column('x')):'y':(1e-9 * column('von_mises')) \
             with points pt 7 ps 0.36 palette
    }
}
unset multiplot
