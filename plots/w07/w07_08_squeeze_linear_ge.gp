# Linear field with gradient enhancement: nothing left but round-off.
load plots.'/style.gp'
load dir.'/'.name.'.var'
load plots.'/squeeze.gp'

floor_ = 1e-17 # exact zeros are drawn here
set yrange [5e-18:1e-12]
set label 1 heading('Squeeze, linear velocity field, gradient enhanced, 100 cells') at graph 0, graph 1.06
shown(e) = e > floor_ ? e : floor_
plot for [m in 'ge_mpm ge_gimp'] csv using (only(m, 'ppc')):(shown(column('error_linf'))) \
         with points ls style(m) ps 0.5 \
         title label(m).sprintf(', at most %.1e', m eq 'ge_mpm' ? W07_8_ge_mpm : W07_8_ge_gimp), \
     1e-13 with lines ls 21 title 'claimed bound, 10^{−13}', \
     floor_ with lines ls 20 title 'exactly 0'
