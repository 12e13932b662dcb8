# Error against what it costs: six problems; CPU time on the left, particle-steps on the right.
tall = 3.3
load plots.'/style.gp'
points_ = dir.'/'.name.'.points.csv'
set multiplot layout 6,2 margins 0.1,0.985,0.09,0.975 spacing 0.09,0.032
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set datafile missing NaN # rows of others are passed over, not gaps
set key off
is(p, m) = strcol('problem') eq p && strcol('method') eq m && \
           (strcol('status') eq 'ok' || strcol('status') eq 'energy_growth')
of(p, m, x) = is(p, m) ? column(x) : NaN
front(p, m, x, which) = is(p, m) && column(which) == 1 ? column(x) : NaN
every(p, x, which) = strcol('problem') eq p && column(which) == 1 ? column(x) : NaN
list_ = points_
load plots.'/methods.gp'
PROBLEMS = 'ring axis_mms vortex plate_vibration sine_bar squeeze'
array TITLE[6] = ['Ring: largest error [m]', 'Axis-aligned displacement: largest error / A', \
                  'Vortex, G = 0.1: largest error [m]', 'Plate, A = 0.4 mm: largest error / A', \
                  'Sine bar, exact law: largest error / A', 'Squeeze, quadratic field: relative error of one projection']
do for [k = 1:6] {
    p = word(PROBLEMS, k)
    set yrange [*:(k == 6 ? 0.03 : 1)]
    set label 1 heading(TITLE[k]) at graph 0, graph 1.05
    do for [c = 1:2] {
        cost = c == 1 ? 'cpu_s' : 'work'
        own = c == 1 ? 'front_own' : 'front_own_work'
        all_ = c == 1 ? 'front' : 'front_work'
        if (c == 2) { unset label 1 }
        set label 2 (c == 1 ? 'CPU time of the step loop [s]' : k == 6 ? 'particles of one projection' : \
            'particle-steps (FEM: element-steps)') at graph 0.98, graph 0.94 right font sprintf(',%d', fmt eq 'png' ? 16 : 11)
        if (k == 6 && c == 1) {
            set key at screen 0.1, screen 0.068 left top maxrows 5 samplen 2.2 width 1
        } else { set key off }
        plot points_ using (every(p, cost, all_)):'error' smooth unique with steps lw 7 lc rgb '#e2e2d6' notitle, \
             for [m in seen_] points_ using (c == 1 ? of(p, m, cost) : NaN):'error' with points ls style(m) ps 0.35 notitle, \
             for [m in seen_] points_ using (front(p, m, cost, own)):'error' smooth unique \
                 with linespoints ls style(m) notitle, \
             keyentry with lines lw 7 lc rgb '#e2e2d6' title 'Pareto front of all', \
             for [m in seen_] keyentry with linespoints ls style(m) title label(m)
    }
}
unset multiplot
