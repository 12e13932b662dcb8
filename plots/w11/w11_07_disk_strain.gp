# Strain energy per volume on the disk's particles at three times, two methods.
tall = 0.9
load plots.'/style.gp'
load plots.'/viridis.gp'
set multiplot layout 2,3 margins 0.08,0.845,0.11,0.94 spacing 0.03,0.1
set size ratio -1
set xrange [0:1]
set yrange [0:0.8]
set xtics 0.5
set ytics 0.5
set border 15
set grid noxtics noytics
unset key
unset colorbox
set cbrange [0:80]
file(m, t) = dir.'/'.name.'.'.m.'.'.t.'.csv'
do for [row = 0:1] {
    m = word('wls gimp', row + 1)
    do for [k = 1:3] {
        t = word('0 2 3', k)
        set label 1 heading(label(m).', t = '.t.' s') at graph 0, graph 1.07
        set label 2 (k == 3 ? 'second impact' : '') at graph 0.04, graph 0.92
        set format y k == 1 ? '%g' : ''
        set format x row ? '%g' : ''
        set xlabel row ? 'x [m]' : ''
        set ylabel (k == 1 ? 'y [m]' : '') offset 1
        if (row == 1 && k == 3) {
            set colorbox user origin 0.865, 0.11 size 0.02, 0.83
            set cblabel 'strain energy per volume [J/m^2]' offset 0.5
        }
        plot file(m, t) using (column('surface') > 0 ? NaN : column('x')):'y':'energy' with points pt 7 ps 0.4 palette
    }
}
unset multiplot
