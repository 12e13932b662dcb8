# Near incompressibility: how much is left of the displacement, and how rough the pressure gets.
tall = 1.5
load plots.'/style.gp'
locking_ = dir.'/'.name.'.locking.csv'
list_ = locking_
load plots.'/methods.gp'
set datafile missing NaN
set multiplot layout 2,2 margins 0.09,0.985,0.2,0.94 spacing 0.1,0.11
at(nu) = nu eq '0.3' ? 0 : nu eq '0.45' ? 1 : nu eq '0.49' ? 2 : 3
of(p, m) = strcol('problem') eq p && strcol('method') eq m && strcol('status') eq 'ok' ? at(strcol('nu')) : NaN
set xrange [-0.2:3.2]
set xtics ('.3' 0, '.45' 1, '.49' 2, '.499' 3)
set key off
PROBLEMS = 'plate_vibration cantilever'
array RATIO[2] = ['Plate, N = 16: amplitude over the exact one', 'Cantilever, N = 4: sinking over FEM''s at h/8']
array BOARD[2] = ['Plate: RMS(p − 3×3 mean) / πμA', 'Cantilever: RMS(p − 3×3 mean) / .01 E']
do for [k = 1:2] {
    p = word(PROBLEMS, k)
    if (k == 2) { set xlabel "Poisson's ratio" } else { unset xlabel }
    unset logscale y
    set yrange [(k == 1 ? 0.95 : 0):(k == 1 ? 1.15 : 1.4)]
    set format y (k == 1 ? '%.2f' : '%.1f')
    set label 1 heading(RATIO[k]) at graph 0, graph 1.06
    plot 1 with lines ls 21, for [m in seen_] locking_ using (of(p, m)):'ratio' with linespoints ls style(m)
    set logscale y
    set yrange [*:*]
    set format y '10^{%T}'
    set label 1 heading(BOARD[k]) at graph 0, graph 1.06
    if (k == 2) { set key at screen 0.09, screen 0.115 left top maxrows 3 samplen 2.2 width 1 }
    plot for [m in seen_] locking_ using (of(p, m)):'checkerboard' with linespoints ls style(m) notitle, \
         for [m in seen_] keyentry with linespoints ls style(m) title label(m)
}
unset multiplot
