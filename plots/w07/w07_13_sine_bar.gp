# Convergence of the sine bar with two laws.
load plots.'/style.gp'
load dir.'/'.name.'.var'

set logscale xy
set xrange [0.12:0.005]
set yrange [4e-5:2]
set xtics ('1/10' 0.1, '1/20' 0.05, '1/40' 0.025, '1/80' 0.0125, '1/160' 0.00625)
set format y '10^{%T}'
set xlabel 'h [m]'
set ylabel 'largest error over a quarter period / A'
set key top right maxrows 5
set label 1 heading('Sine bar: exact law (solid) and neo-Hookean (dashed)') at graph 0, graph 1.06
of(m, law) = strcol('method') eq m && strstrt(strcol('params'), 'law='.law) > 0 \
             && (strcol('status') eq 'ok' || strcol('status') eq 'energy_growth') ? column('h') : NaN
order(m) = m eq 'gimp' ? W07_13_gimp_order : m eq 'ge_gimp' ? W07_13_ge_gimp_order : W07_13_mpm_order
plot for [m in 'mpm gimp ge_gimp'] csv using (of(m, 'linear')):'error_linf' with linespoints ls style(m) \
         title label(m).', order '.minus(sprintf('%.2f', order(m))), \
     for [m in 'mpm gimp ge_gimp'] csv using (of(m, 'neo_hookean')):'error_linf' with linespoints \
         ls style(m) dt 2 title label(m).', neo-Hookean', \
     2 * x**2 with lines ls 20 title 'h^{ 2}', \
     0.5 * 0.01 with lines ls 21 title 'A/2'
