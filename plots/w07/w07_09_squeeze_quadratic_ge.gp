# Quadratic field with and without gradient enhancement.
load plots.'/style.gp'
load dir.'/'.name.'.var'
load plots.'/squeeze.gp'

set yrange [3e-6:3e-2]
set label 1 heading('Squeeze, quadratic velocity field, with and without gradient, 100 cells') \
    at graph 0, graph 1.06
from(m) = m eq 'ge_mpm' ? W07_9_ge_mpm_settles : m eq 'ge_gimp' ? W07_9_ge_gimp_settles : NaN
says(m) = from(m) > 0 ? sprintf(', within twice the plateau from PPC %.2f', from(m)) : ''
plot for [m in 'mpm gimp ge_mpm ge_gimp'] csv using (only(m, 'ppc')):'error_linf' \
         with linespoints ls style(m) ps 0.35 title label(m).says(m), \
     plateau with lines ls 21 title 'plateau, h²/6/(1+h)²'
