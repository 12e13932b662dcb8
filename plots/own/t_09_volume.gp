# Marching cubes: the fifteen cases as polyhedra; the error of a shell's volume by distance rule.
tall = 0.9
load plots.'/style.gp'
load dir.'/'.name.'.var'
shapes = dir.'/'.name.'.shapes.csv'
volume = dir.'/'.name.'.volume.csv'
stats shapes using 'face' nooutput name 'F'
set multiplot
set lmargin at screen 0.02; set rmargin at screen 0.56
set bmargin at screen 0.28; set tmargin at screen 0.9
set label 1 heading('(a) the fifteen cases of a cut cube') at graph 0.02, graph 1.04
set size ratio -1
unset border; unset tics; unset grid; unset key
set xrange [-0.1:9.6]
set yrange [-4.05:1.5]
IN = COLOUR[style('wls2')]
CUT = COLOUR[style('gimp')]
array X[13] = [0, 1, 1, 0, 0, 0.45, 1.45, 1.45, 0.45, 0.45, 1.45, 1, 1.45]
do for [s = 0:14] {
    a = 2 * (s % 5); b = -1.9 * int(s / 5)
    set object 4 * s + 1 polygon from a,b to a + 1,b to a + 1,b + 1 to a,b + 1 to a,b fs empty border lc rgb '#bbbbbb'
    set object 4 * s + 2 polygon from a + .45,b + .35 to a + 1.45,b + .35 to a + 1.45,b + 1.35 to a + .45,b + 1.35 \
        to a + .45,b + .35 fs empty border lc rgb '#bbbbbb'
    set arrow 4 * s + 1 from a,b to a + .45,b + .35 nohead lc rgb '#bbbbbb'
    set arrow 4 * s + 2 from a + 1,b to a + 1.45,b + .35 nohead lc rgb '#bbbbbb'
    set arrow 4 * s + 3 from a + 1,b + 1 to a + 1.45,b + 1.35 nohead lc rgb '#bbbbbb'
    set arrow 4 * s + 4 from a,b + 1 to a + .45,b + 1.35 nohead lc rgb '#bbbbbb'
}
plot for [f = 0:int(F_max)] for [c = 0:1] shapes \
     using (column('face') == f && column('cut') == c ? column('x') : NaN):'y' \
     with filledcurves closed fc rgb (c ? CUT : IN) fs transparent solid (c ? 0.55 : 0.3) border lc rgb (c ? CUT : IN)
unset object
unset arrow

set size noratio
set lmargin at screen 0.66; set rmargin at screen 0.985
set bmargin at screen 0.44; set tmargin at screen 0.9
set label 1 heading('(b) volume of a shell, error') at graph 0, graph 1.07
set border 3 lw 1 lc rgb '#444444'
set grid xtics ytics lt 1 dt 1 lw 0.7 lc rgb '#e3e3e3'
set logscale xy
set xrange [7:27]
set xtics (8, 12, 16, 24) nomirror
set autoscale y
set ytics nomirror
set format y '10^{%T}'
set xlabel 'cells over the outer radius, N'
set ylabel 'relative error'
set key at screen 0.6, screen 0.29 left top samplen 2
rule(r) = strcol('rule') eq r ? column('cells') : NaN
text(r) = exists(r) && value(r) == value(r) ? minus(sprintf(', order %.2f', value(r))) : ''
plot volume using (rule('weighted_mean')):'error' with linespoints ls style('wls') title 'mean of points, eqs 15-17'.text('weighted_mean'), \
     '' using (rule('normals')):'error' with linespoints ls style('wls2') title 'along normals'.text('normals'), \
     '' using (rule('exact')):'error' with linespoints ls style('fem') title 'exact distances'.text('exact'), \
     '' using (rule('curved')):'error' with linespoints ls style('ge_wls') title 'curved'.text('curved'), \
     1 / x**2 with lines ls 20 title 'N^{ −2}', 1 / x**4 with lines ls 21 title 'N^{ −4}'
unset multiplot
