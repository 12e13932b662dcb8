# Hoop stress on the surface of a cavity beside fine FEM; how far each method is from it on two meshes.
load plots.'/style.gp'
load dir.'/'.name.'.var'
rim = dir.'/'.name.'.rim.csv'
SHOWN = 'fem wls wls2 ge_wls gimp'
says(m) = exists('rms_'.m) ? sprintf(', rms %.1f, scatter %.1f', value('rms_'.m), value('scatter_'.m)) : ''
stats rim using (strcol('run') eq 'coarser' ? NaN : column('cells')) nooutput
N = int(STATS_max) # of the finest mesh that ran
of(m, x) = strcol('run') eq sprintf('%s.%d', m, N) ? column(x) : NaN

set multiplot layout 1,2 margins 0.09,0.985,0.34,0.92 spacing 0.06
set xrange [0:90]
set xtics 15
set xlabel 'angle from the direction of pull [degrees]'
do for [k = 1:2] {
    set label 1 heading(k == 1 ? sprintf('(a) N = %d, points within .35 h of the cavity', N) : '(b) less the reference') at graph 0, graph 1.05
    set ylabel k == 1 ? 'hoop stress [GPa]' : ''
    if (k == 1) { set key at screen 0.09, screen 0.24 left top maxrows 3 samplen 2 width 2 } else { unset key }
    plot for [m in SHOWN] rim using (of(m, 'angle')):(k == 1 ? column('hoop') : column('hoop') - column('reference')) \
         with points ls style(m) ps 0.7 title label(m).says(m), \
         rim using (k == 1 ? of('gimp', 'angle') : NaN):'reference' with points pt 7 ps 0.35 lc rgb '#222222' \
         title k == 1 ? 'fine FEM, at the points of GIMP' : ''
}
unset multiplot
