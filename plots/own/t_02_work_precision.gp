# Error against CPU time, one panel per problem: the Pareto front, the methods on it and FEM; all
# other methods thin and grey.
tall = 2.1
load plots.'/style.gp'
points_ = dir.'/'.name.'.points.csv'
list_ = points_
load plots.'/methods.gp'
set datafile missing NaN # rows of others are passed over, not gaps
PROBLEMS = 'ring axis_mms vortex plate_vibration sine_bar squeeze'
array TITLE[6] = ['Ring: largest error [m]', 'Axis-aligned waves: largest error / A', \
                  'Vortex, G = 0.1: largest error [m]', 'Plate, A = 0.4 mm: largest error / A', \
                  'Sine bar, exact law: largest error / A', 'Squeeze, quadratic field: relative error']
is(p, m) = strcol('problem') eq p && strcol('method') eq m && \
           (strcol('status') eq 'ok' || strcol('status') eq 'energy_growth')
own(p, m) = is(p, m) && column('front_own') == 1 ? column('cpu_s') : NaN
best(p) = strcol('problem') eq p && column('front') == 1 ? column('cpu_s') : NaN
shown(p) = best(p) == best(p) || is(p, 'fem')
on(m) = strstrt(ON.' ', ' '.m.' ') > 0
set multiplot
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
small = sprintf(',%d', fmt eq 'png' ? 15 : 10)
do for [k = 1:6] {
    p = word(PROBLEMS, k)
    row = (k - 1) / 2
    set lmargin at screen (k % 2 ? 0.09 : 0.585)
    set rmargin at screen (k % 2 ? 0.475 : 0.965)
    set tmargin at screen 0.965 - 0.32 * row
    set bmargin at screen 0.965 - 0.32 * row - 0.235
    ON = ''
    set datafile columnheaders
    stats points_ using (shown(p) ? (ON = ON.' '.strcol('method'), 1) : 1) nooutput
    unset datafile columnheaders
    set label 1 heading(TITLE[k]) at graph 0, graph 1.05
    set xlabel 'CPU time of the step loop [s]'
    set key at graph 1, graph 1 right top samplen 1.6 font small spacing 1.05
    if (p eq 'sine_bar') { set key at graph 0.01, graph 0.01 left bottom spacing 0.9 } # no curve is there
    plot points_ using (best(p)):'error' smooth unique with steps lw 7 lc rgb '#e2e2d6' title 'Pareto front', \
         for [m in seen_] points_ using (on(m) ? NaN : own(p, m)):'error' smooth unique with lines lw 0.7 lc rgb '#b8b8b8' notitle, \
         for [m in seen_] points_ using (on(m) ? own(p, m) : NaN):'error' smooth unique with linespoints ls style(m) notitle, \
         for [m in seen_] keyentry with linespoints ls (on(m) ? style(m) : OTHER) title (on(m) ? label(m) : '')
}
unset multiplot
