# The shapes that a surface cuts out of a cell.
tall = 0.82
load plots.'/style.gp'
array TITLE[6] = ['(a) triangle', '(b) quadrilateral', '(c) pentagon', '(d) square', \
                  '(e) saddle, mean > 0', '(f) saddle, mean < 0']
set multiplot layout 2,3 margins 0.03,0.97,0.05,0.93 spacing 0.05,0.12
set size ratio -1
unset border
unset tics
unset grid
unset key
sign(x) = x > 0 ? '+' : '−'
array CX[4] = [0, 1, 0, 1]
array CY[4] = [0, 0, 1, 1]
array D[4]
do for [s = 0:5] {
    set autoscale
    stats csv using (column('shape') == s ? column('d00') : NaN) nooutput name 'A'
    stats csv using (column('shape') == s ? column('d10') : NaN) nooutput name 'B'
    stats csv using (column('shape') == s ? column('d01') : NaN) nooutput name 'C'
    stats csv using (column('shape') == s ? column('d11') : NaN) nooutput name 'E'
    D[1] = A_mean; D[2] = B_mean; D[3] = C_mean; D[4] = E_mean
    set xrange [-0.15:1.15]
    set yrange [-0.15:1.15]
    do for [k = 1:4] {
        set label k + 1 sign(D[k]) at CX[k] + 0.08 * (2 * CX[k] - 1), CY[k] + 0.08 * (2 * CY[k] - 1) center
    }
    set label 1 heading(TITLE[s + 1]) at graph 0.12, graph 1.03
    set object 1 rectangle from 0,0 to 1,1 fs empty border lc rgb '#999999' front
    plot for [p = 0:1] csv using (column('shape') == s && column('piece') == p ? column('x') : NaN):'y' \
             with filledcurves closed fc rgb COLOUR[style('wls2')] fs transparent solid 0.3 border lc rgb COLOUR[style('wls2')], \
         csv using (column('shape') == s ? column('x') : NaN):'y' with points pt 7 ps 0.6 lc rgb COLOUR[style('wls2')]
}
unset multiplot
