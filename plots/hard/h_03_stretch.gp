# Stress that the particles know of, over the right one, against stretch.
load plots.'/style.gp'
list_ = dir.'/'.name.'.curves.csv'
load plots.'/methods.gp'
fixed_ = 0
stats list_ using (fixed_ = fixed_ || strcol('variant') eq 'undeformed', 1) nooutput
KINDS = 'bar1 bar2 plane'
array SAYS[3] = ['Bar, 1 per cell', 'Bar, 2 per cell', 'Plane, 2 × 2 per cell']
set multiplot
set xrange [1:4.05]
set yrange [0:1.12]
set bmargin at screen 0.13
set tmargin at screen 0.9
set xtics 1
set xlabel 'stretch'
do for [k = 1:3] {
    set lmargin at screen 0.08 + 0.25 * (k - 1)
    set rmargin at screen 0.31 + 0.25 * (k - 1)
    if (k == 1) { set ylabel 'mean stress / right stress' offset 1 } else { unset ylabel; set format y '' }
    if (k == 3) { set key at screen 0.825, screen 0.9 left top samplen 1.6 } else { unset key }
    of(m, v) = strcol('method') eq m && strcol('variant') eq v && strcol('kind') eq word(KINDS, k) ? column('stretch') : NaN
    set label 1 heading(SAYS[k]) at graph 0, graph 1.05
    plot for [m in seen_] list_ using (of(m, 'usual')):'ratio' with lines ls style(m) lw 2.4 title label(m), \
         for [m in fixed_ ? 'gimp' : ''] list_ using (of(m, 'undeformed')):'ratio' with lines ls style(m) lw 2.4 dt 2 title 'GIMP, fixed l'
}
unset multiplot
