# Quadratic field: the lobes of fig. 5 descend to a plateau.
load plots.'/style.gp'
load dir.'/'.name.'.var'
load plots.'/squeeze.gp'

set yrange [1e-6:3e-2]
set label 1 heading('Squeeze, quadratic velocity field, 100 cells') at graph 0, graph 1.06
plot csv using (only('mpm', 'ppc')):'error_linf' with linespoints ls style('mpm') ps 0.35 \
         title label('mpm').sprintf(', within twice the plateau from PPC %.2f', W07_6_mpm_settles), \
     csv using (only('gimp', 'ppc')):'error_linf' with linespoints ls style('gimp') ps 0.35 \
         title label('gimp').sprintf(', from PPC %.2f', W07_6_gimp_settles), \
     plateau with lines ls 21 title 'plateau, h²/6/(1+h)²'
