# A grid: method x integrator, what becomes of the energy in ten periods.
load plots.'/style.gp'

grid_ = dir.'/'.name.'.grid.csv'
array SHADE[4] = [0xd7ecd9, 0xf6efcf, 0xf7d9b5, 0xf0b8b0]
array MEANING[4] = ['energy within 0.1 %', 'within 5 %', 'changed by more', 'lost after so many periods T']
stats grid_ using 'line' nooutput
lines_ = STATS_max + 1
set xrange [-0.5:6.5]
set yrange [lines_ - 0.5:-0.5]
unset grid
set border 0
set tics scale 0
set x2tics ('cd' 0, 'usl' 1, 'musl' 2, 'uvf' 3, 'usf' 4, 'musl, fresh L' 5, 'uvf, fresh L' 6)
unset xtics
set x2range [-0.5:6.5]
set ytics ()
array NAMES[lines_]
stats grid_ using (NAMES[int(column('line')) + 1] = strcol('method'), 1) nooutput
do for [k = 1:lines_] { set ytics add (label(NAMES[k]) k - 1) }
set key below maxrows 1 samplen 1.5
set tmargin 6
set lmargin 10
set label 1 heading('Ten periods of the sine bar, CFL 0.1: energy at the end, by method and integrator') \
    at graph 0, graph 1.16
set style fill solid 1 border rgb '#ffffff'
plot grid_ using 'column':'line':(0.49):(0.47):(SHADE[int(column('grade')) + 1]) with boxxyerror \
         lc rgb variable notitle, \
     grid_ using 'column':'line':(strcol('text')) with labels noenhanced font sprintf(',%d', fmt eq 'png' ? 15 : 10) notitle, \
     for [k = 1:4] NaN with points pt 5 ps 2.5 lc rgb SHADE[k] title MEANING[k]
