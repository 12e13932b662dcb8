# Von Mises stress along the hole beside fine FEM; and how far each method is from it on five meshes.
tall = 1.3
load plots.'/style.gp'
load dir.'/'.name.'.var'
rim = dir.'/'.name.'.rim.csv'
sums = dir.'/'.name.'.sums.csv'
small = fmt eq 'png' ? ',15' : ',10'
rms(m) = exists('rms_'.m) ? value('rms_'.m) : NaN
known(m) = rms(m) == rms(m)
says(m) = sprintf(', rms %.1f, scatter %.1f', rms(m), value('scatter_'.m))
of(m, x) = strcol('method') eq m ? column(x) : NaN

set multiplot
set lmargin at screen 0.09
set rmargin at screen 0.97
set tmargin at screen 0.95
set bmargin at screen 0.54
set label 1 heading('(a) h = 1/32, points within .35 h of the hole, t = 696 µs') at graph 0, graph 1.05
set xrange [0:90]
set xtics 15
set yrange [-5:165]
set ytics 50
set xlabel 'angle along the hole [degrees]'
set ylabel 'von Mises stress [GPa]'
set key at graph 0.02, graph 0.97 left top
plot rim using (column('cells') == 32 ? of('wls', 'angle') : NaN):'reference' with lines lc rgb '#222222' lw 2 title 'FEM, h = 1/256, at the points of WLS', \
     for [m in 'fem wls wls2 ge_wls gimp'] known(m) ? rim : '/dev/null' \
         using (column('cells') == 32 ? of(m, 'angle') : NaN):'von_mises' \
         with points ls style(m) ps 0.9 title label(m).says(m)

set tmargin at screen 0.43
set bmargin at screen 0.09
set logscale xy
set xrange [14:72]
set yrange [0.05:200]
set xtics (16, 23, 32, 45, 64)
set ytics (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200)
set xlabel 'cells per unit length, N'
unset key
do for [k = 1:2] {
    set lmargin at screen (k == 1 ? 0.09 : 0.51)
    set rmargin at screen (k == 1 ? 0.42 : 0.80)
    set label 1 heading(k == 1 ? '(b) rms difference' : '(c) its scatter')
    set ylabel k == 1 ? '[GPa]' : ''
    if (k == 2) { set key at screen 0.81, screen 0.44 left top maxcols 1 spacing 0.95 samplen 1.8 font small }
    plot for [m in METHODS] exists('rms_'.m) ? sums : '/dev/null' using (of(m, 'cells')):(k == 1 ? column('rms') : column('scatter')) \
         with linespoints ls style(m) title exists('rms_'.m) ? label(m).(known(m) ? '' : ' (lost)') : ''
}
unset multiplot
