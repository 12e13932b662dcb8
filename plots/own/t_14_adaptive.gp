# Adaptive steps over the first one, and total energy, on the disk and the hanging bar.
tall = 0.9
load plots.'/style.gp'
load dir.'/'.name.'.var'
file(s, m) = dir.'/'.name.'.'.s.'_'.m.'.csv'
set multiplot layout 1,2 margins 0.09,0.985,0.16,0.9 spacing 0.1
set xlabel 't [s]'
set label 1 heading('(a) disk: adaptive step') at graph 0, graph 1.05
set ylabel 'step over that of a body at rest'
set yrange [0.5:1.02]
set key bottom right
first = 1
plot for [m in 'gimp wls2 fem'] file('disk_impact', m) \
  using 't':(first = column(0) == 0 ? column('dt') : first, column('dt')/first) \
  with lines ls style(m) title label(m)
set label 1 heading('(b) disk: total energy, adaptive steps')
set ylabel 'energy / E_0'
set yrange [0.92:1.04]
plot for [m in 'gimp wls2 fem'] file('disk_impact', m) \
  using 't':(first = column(0) == 0 ? column('total') : first, column('total')/first) \
  with lines ls style(m) title label(m)
unset multiplot
