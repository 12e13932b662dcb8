# Spurious nodes: error, and spurious nodes of a step, against the trigger weight; determinant and count on the left.
tall = 1.1
load plots.'/style.gp'
map = dir.'/'.name.'.map.csv'
set multiplot layout 2,3 margins 0.1,0.985,0.2,0.92 spacing 0.03,0.09
set logscale xy
set xrange [0.002:0.62]
set xtics ('count' 0.0035, 'det.' 0.0085, '.02' 0.02, '.05' 0.05, '.12' 0.12, '.25' 0.25, '.5' 0.5)
spot(c, w) = c eq 'count' ? 0.0035 : c eq 'determinant' ? 0.0085 : w
pick(m, l, p, gone, by) = (strcol('method') eq m && strcol('layout') eq l && column('fill') == p \
    && column('lost') == gone && ((strcol('condition') eq 'weight') == by)) ? spot(strcol('condition'), column('trigger')) : NaN
kind(k) = word('wls wls wls2 wls2', k)
lay(k) = word('fitted lattice fitted lattice', k)
dash(k) = k % 2 ? 1 : 2
do for [row = 0:1] {
    do for [k = 1:3] {
        p = int(word('1 4 9', k))
        set format x row ? '%g' : ''
        set format y k == 1 ? '10^{%T}' : ''
        set ylabel k == 1 ? (row ? 'spurious nodes of a step' : 'largest error [m]') : ''
        set xlabel row ? 'test, trigger weight' : ''
        set yrange [row ? 0.03 : 2e-4:row ? 300 : 1]
        if (row) { unset label 1 } else { set label 1 heading(word('1 4 9', k).' per cell') at graph 0, graph 1.06 }
        if (row && k == 1) { set key at screen 0.1, screen 0.105 left top maxrows 2 samplen 2.4 width 1 } else { unset key }
        what = row ? 'spurious' : 'error'
        plot for [j = 1:4] map using (pick(kind(j), lay(j), p, 0, 1)):(column(what)) with linespoints ls style(kind(j)) dt dash(j) \
                 title label(kind(j)).(j % 2 ? ', fitted' : ', lattice'), \
             for [j = 1:4] map using (pick(kind(j), lay(j), p, 0, 0)):(column(what)) with points ls style(kind(j)) notitle, \
             for [j = 1:4] map using (pick(kind(j), lay(j), p, 1, 1)):(column(what)) with points ls style(kind(j)) pt 2 ps 0.9 \
                 title (j == 1 ? 'lost, until then' : ''), \
             for [j = 1:4] map using (pick(kind(j), lay(j), p, 1, 0)):(column(what)) with points ls style(kind(j)) pt 2 ps 0.9 notitle
    }
}
unset multiplot
