# What a particle-step costs: bars of the step loop's CPU time (-run: of the whole run's wall clock), beside what the
# machine could do at best.
tall = 1.6
load plots.'/style.gp'
set style fill solid 0.85 noborder
set style data boxes
set boxwidth 0.62
set grid noytics xtics
set yrange [*:*] reverse
set offsets 0, 0, 0.4, 0.4
set logscale x
set xrange [3:2000]
set xlabel 'CPU time of one particle-step (FEM: element-step; -run: wall clock of a whole run) [ns]'
set label 1 heading('Speed of the step loop, one core') at graph 0, graph 1.03
set lmargin 24
unset key
set ytics noenhanced # names of methods: no subscripts
bar = 0.31
named(name, integrator) = strcol(name).(strcol(integrator) eq '-' ? '' : ', '.strcol(integrator))
colour(c) = c[1:5] eq 'bound' || c[1:4] eq 'two-' ? 0x999999 : c eq 'twin' || c[1:4] eq 'bare' ? 0xD55E00 : c[1:3] eq 'fem' ? 0x000000 : 0x0072B2
cost(c) = c[strlen(c) - 3:] eq '-run' ? column(10) : column(3)
plot csv skip 1 using (3):0:(3):(cost(strcol(1))):($0 - bar):($0 + bar):(colour(strcol(1))):ytic(named(1, 9)) \
         with boxxyerror lc rgb variable, \
     csv skip 1 using (cost(strcol(1))):0:(sprintf(' %.3g', cost(strcol(1)))) with labels left offset 0.3, 0
