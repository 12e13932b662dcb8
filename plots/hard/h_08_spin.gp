# Ten turns: area after imposed ones, angular momentum lost in free ones.
load plots.'/style.gp'
list_ = dir.'/'.name.'.turns.csv'
load plots.'/methods.gp'
VARIANTS = 'usual stretch exponential subcycled'
array SAYS[4] = ['as it comes', 'domain=stretch', 'strain\_update=exponential', 'subcycled']
array KIND[4] = [7, 5, 9, 13]
of(s, v, ok) = strcol('scene') eq s && strcol('variant') eq word(VARIANTS, v) && (strcol('status') eq 'ok') == ok ? \
    at_(strcol('method')) + 0.16 * (v - 2.5) : NaN
array HAS[4]
do for [v = 1:4] {
    HAS[v] = 0
    stats list_ using (strcol('variant') eq word(VARIANTS, v) ? (HAS[v] = 1) : 0, 1) nooutput
}
set multiplot
set xrange [-0.7:words(seen_) - 0.3]
set xtics () rotate by 40 right
do for [k = 1:words(seen_)] { set xtics add (label(word(seen_, k)) k - 1) }
set bmargin at screen 0.2
set tmargin at screen 0.82
set lmargin at screen 0.09
set rmargin at screen 0.49
set yrange [0.9:3.6]
set ylabel 'area / its right value' offset 1
set label 1 heading('(a) imposed: area after ten turns') at graph 0, graph 1.06
set key at screen 0.09, screen 0.99 left top maxrows 2 samplen 1
set label 2 'e^{20 π ω Δt}' at graph 0.02, first 3.36 textcolor rgb '#666666'
plot exp(20 * pi * 0.3 / 16) with lines ls 21 notitle, \
     for [v = 1:4] list_ using (of('spin', v, 1)):'J' with points pt KIND[v] ps 1.1 lc rgb VARIANT[v] \
         title HAS[v] ? SAYS[v] : ''
set lmargin at screen 0.61
set rmargin at screen 0.985
unset label 2
set key off
set logscale y
set yrange [1e-7:3]
set format y '10^{%T}'
set ylabel 'share lost per turn' offset 0
set label 1 heading('(b) free: angular momentum (× run lost)')
plot for [v = 1:4] list_ using (of('free', v, 1)):(abs(column('loss'))) with points pt KIND[v] ps 1.1 lc rgb VARIANT[v], \
     for [v = 1:4] list_ using (of('free', v, 0)):(1) with points pt 2 ps 1.1 lw 2 lc rgb VARIANT[v]
unset multiplot
