# The plateau at three meshes.
load plots.'/style.gp'
load dir.'/'.name.'.var'
load plots.'/squeeze.gp'

set yrange [2e-6:3e-3]
set label 1 heading('Squeeze, quadratic velocity field, GE-GIMP, three meshes') at graph 0, graph 1.06
plateau(h) = h**2 / 6 / (1 + h)**2
array DASH[3] = [1, 2, 4]
at(cells) = column('cells') == cells ? column('ppc') : NaN
plot for [k = 1:3] csv using (at(25 * 2**k)):'error_linf' with lines ls style('ge_gimp') dt DASH[k] \
         lw 2 title sprintf('%s, h = 1/%d', label('ge_gimp'), 25 * 2**k), \
     for [k = 1:3] plateau(1 / (25.0 * 2**k)) with lines ls 20 lw 0.8 \
         title k == 1 ? sprintf('h²/6/(1+h)², measured order %.2f', W07_10_order) : ''
