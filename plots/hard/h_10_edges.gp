# Largest projection error of all nodes, edges included, against h: four bodies.
tall = 1.2
load plots.'/style.gp'
list_ = csv
load plots.'/methods.gp'
BODIES = 'block strip corner slit'
array SAYS[4] = ['Block', 'Strip, 1.5 cells thick', 'Concave corner', 'Two surfaces in a cell']
set logscale xy
set xrange [1 / 150.:1 / 13.]
set xtics ('1/16' 1 / 16., '1/32' 1 / 32., '1/64' 1 / 64., '1/128' 1 / 128.)
set yrange [1e-17:1]
set ytics 1e-16, 1e4
set format y '10^{%T}'
set multiplot
do for [k = 1:4] {
    set lmargin at screen (k % 2 ? 0.09 : 0.47)
    set rmargin at screen (k % 2 ? 0.42 : 0.8)
    set tmargin at screen (k < 3 ? 0.93 : 0.46)
    set bmargin at screen (k < 3 ? 0.58 : 0.11)
    if (k > 2) { set xlabel 'h [m]' }
    if (k % 2) { set format y '10^{%T}'; set ylabel 'largest error' offset 1 } else { unset ylabel; set format y '' }
    if (k == 2) { set key at screen 0.815, screen 0.93 left top maxcols 1 spacing 1 samplen 1.6 font fmt eq 'png' ? ',15' : ',10' } else { unset key }
    of(m) = strcol('method') eq m && strstrt(strcol('params'), 'body='.word(BODIES, k).';') ? column('h') : NaN
    set label 1 heading(SAYS[k]) at graph 0, graph 1.07
    plot for [m in seen_] csv using (of(m)):'error_linf' with linespoints ls style(m) title label(m)
}
unset multiplot
