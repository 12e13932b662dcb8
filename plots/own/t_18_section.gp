# Radial and hoop stress of the oscillating shell at three times, in the section |Z| < h/2.
load plots.'/style.gp'
points = dir.'/'.name.'.points.csv'
# Signed: blue is compression, red tension.
set palette defined (-3 '#2166ac', -2 '#67a9cf', -1 '#b5d5e8', 0 '#dcdcdc', 1 '#f6c1a5', 2 '#ef8a62', 3 '#b2182b')
set multiplot layout 2,3 margins 0.09,0.845,0.11,0.94 spacing 0.03,0.09
set size ratio -1
set xrange [0:1.25]
set yrange [0:1.25]
set xtics 0.5
set ytics 0.5
set grid noxtics noytics
unset key
unset colorbox
set cbrange [-3000:3000]
shown(ms) = strcol('method') eq 'ge_wls' && strcol('instant') eq ms
do for [row = 0:1] {
    do for [k = 1:3] {
        ms = word('0 5 10', k)
        set label 1 heading((row ? 'hoop' : 'radial').', t = '.ms.' ms') at graph 0, graph 1.06
        set format y k == 1 ? '%g' : ''
        set format x row ? '%g' : ''
        set xlabel row ? 'x [m]' : ''
        set ylabel (k == 1 ? 'y [m]' : '') offset 1
        if (row == 1 && k == 3) {
            set colorbox user origin 0.865, 0.11 size 0.02, 0.83
            set cblabel 'Cauchy stress, GE-WLS [Pa]' offset 0.5
        }
        plot points using (shown(ms.'ms') ? column('x') : NaN):'y':(row ? column('hoop') : column('radial')) \
            with points pt 7 ps 0.5 palette
    }
}
unset multiplot
