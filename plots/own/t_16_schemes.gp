# Schemes on request: quadrature of splines by particles that do not fit, forces in a turned block.
tall = 0.85
load plots.'/style.gp'
mass_ = dir.'/'.name.'.mass.csv'
force_ = dir.'/'.name.'.force.csv'
set multiplot
set lmargin at screen 0.09
set rmargin at screen 0.48
set tmargin at screen 0.88
set bmargin at screen 0.24
set label 1 heading('(a) bar: masses of nodes') at graph 0, graph 1.05
set logscale xy
set xrange [2.2:9.5]
set yrange [1e-6:0.1]
set xtics (2.5, 3.5, 4.5, 6.5, 8.5)
set format y '10^{%T}'
set xlabel 'particles per cell'
set ylabel 'largest error / ρh'
set key bottom left
plot for [m in 'mpm bspline bspline3'] mass_ using (only(m, 'ppc')):'error' with linespoints ls style(m) title label(m), \
     1/(4*x**2) ls 21 title '1/4 n^{−2}, 1/16 n^{−3}, 1/48 n^{−4}', 1/(16*x**3) ls 21 notitle, 1/(48*x**4) ls 21 notitle

unset logscale x
unset key
set lmargin at screen 0.61
set rmargin at screen 0.965
set label 1 heading('(b) turned block: force inside')
unset xlabel
set ylabel 'force / (E · face of a cell)' offset 1
BLOCKS = 'mpm gimp apic mls_mpm bspline3 tlmpm cpdi cpdi2 impm'
set xrange [-0.6:words(BLOCKS) - 0.4]
set yrange [1e-18:1]
set ytics 1e3
set xtics () rotate by -40
do for [k = 1:words(BLOCKS)] { set xtics add (label(word(BLOCKS, k)) k - 1) }
set boxwidth 0.7
set style fill solid 0.8 noborder
least(f) = f > 2e-18 ? f : 2e-18 # none at all
plot for [m in BLOCKS] force_ using (only(m, 'place')):(least(column('force'))) with boxes ls style(m) notitle
unset multiplot
