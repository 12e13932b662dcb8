# Convergence of the plate at two amplitudes.
load plots.'/style.gp'
load dir.'/'.name.'.var'

set logscale xy
set xrange [0.16:0.0062]
set yrange [3e-4:0.6]
set xtics ('1/8' 0.125, '1/16' 0.0625, '1/32' 0.03125, '1/64' 0.015625, '1/128' 0.0078125)
set format y '10^{%T}'
set xlabel 'h [m]'
set ylabel 'largest error over a quarter period / A'
set key top right maxrows 5
set label 1 heading('Plate vibration: A = 4 mm (solid) and 0.4 mm (dashed)') at graph 0, graph 1.06
of(m, A, law) = strcol('method') eq m && strstrt(strcol('params'), 'A='.A.';law='.law) == 1 \
                ? column('h') : NaN
order(m) = m eq 'gimp' ? W07_15_gimp_order : m eq 'ge_gimp' ? W07_15_ge_gimp_order : NaN
says(m) = order(m) > 0 ? sprintf(', order %.2f to 1/32', order(m)) : ''
plot for [m in 'mpm gimp ge_gimp'] csv using (of(m, '0.004', 'neo')):'error_linf' with linespoints \
         ls style(m) title label(m).', 4 mm', \
     for [m in 'mpm gimp ge_gimp'] csv using (of(m, '0.0004', 'neo')):'error_linf' with linespoints \
         ls style(m) dt 2 title label(m).', 0.4 mm'.says(m), \
     csv using (of('ge_gimp', '0.004', 'linear')):'error_linf' with linespoints ls style('ge_gimp') dt 4 \
         title label('ge_gimp').', 4 mm, linear law', \
     2 * x**2 with lines ls 20 title 'h^{ 2}', \
     pi * 0.004 / 4 with lines ls 21 title 'π A/4, A = 4 mm'
