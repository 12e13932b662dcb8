# Hard cases in three dimensions: forces inside a moving body, and what is left of modes and rotation.
load plots.'/style.gp'
found = dir.'/'.name.'.found.csv'
SHOWN = 'mpm gimp ge_gimp bspline apic tpic wls wls2 ge_wls'
line(m) = (sum [k = 1:words(SHOWN)] (word(SHOWN, k) eq m ? k : 0))
at(what) = strcol('what') eq what ? line(strcol('method')) : NaN
above(x) = x < 1e-16 ? 1e-16 : x
set multiplot
set bmargin at screen 0.24
set tmargin at screen 0.9
set xrange [0.5:9.5]
set xtics () rotate by 60 right
do for [k = 1:9] { set xtics add (label(word(SHOWN, k)) k) }
set lmargin at screen 0.12; set rmargin at screen 0.37
set logscale y
set format y '10^{%T}'
set label 1 heading('(a) H-1: force inside') at graph 0, graph 1.06
set ylabel 'largest force / (|σ| A)' offset 1
set key at screen 0.02, screen 0.06 left bottom maxrows 1
plot found using (at('stretch')):(above(column('value'))) with points pt 7 ps 1.2 lc rgb '#4477aa' title 'stretched', \
     '' using (at('turned')):(above(column('value'))) with points pt 6 ps 1.4 lc rgb '#cc3311' title 'turned by 30°'
unset logscale y
unset ylabel
unset key
set format y '%g'
set lmargin at screen 0.43; set rmargin at screen 0.68
set yrange [-0.05:1.15]
set label 1 heading('(b) H-2: amplitude left')
plot found using (at('ripple')):'value' with points pt 7 ps 1.2 lc rgb '#4477aa'
set lmargin at screen 0.74; set rmargin at screen 0.985
set yrange [0.92:1.01]
set label 1 heading('(c) H-8: J over e^{2πωΔt}')
plot found using (at('spin')):'value' with points pt 7 ps 1.2 lc rgb '#4477aa'
unset multiplot
