# A sweep of run options: one curve for each combination of all but one of them. Every run has its place: lost
# ones are crosses along the top, values of exactly 0 on a logarithmic axis are circles along the bottom.
load plots.'/style.gp'
load dir.'/'.name.'.var'
orders_ = dir.'/'.name.'.orders.csv'
curves_ = dir.'/'.name.'.curves.csv'
stats orders_ using 'series' nooutput
curves = int(STATS_max) + 1
array TITLE[curves]
array ORDER[curves]
array REASON[curves]
array LOST[curves]
array RUNS[curves]
stats orders_ using (k_ = int(column('series')) + 1, TITLE[k_] = strcol('curve'), ORDER[k_] = strcol('order'), \
                     REASON[k_] = strcol('reason'), LOST[k_] = int(column('lost')), \
                     RUNS[k_] = int(column('cases')), 1) nooutput
lost_runs = sum [k = 1:curves] LOST[k]
runs = sum [k = 1:curves] RUNS[k]

# The axes are set before anything is drawn, so that a sweep without a single good value has its figure, too.
pad(low, high) = high > low ? 0.05 * (high - low) : abs(high) > 0 ? 0.1 * abs(high) : 1
if (x_log) {
    set logscale x
    set xrange [x_low * (x_low / x_high) ** 0.05 : x_high * (x_high / x_low) ** 0.05]
} else {
    set xrange [x_low - pad(x_low, x_high) : x_high + pad(x_low, x_high)]
}
if (y_log) {
    decades = log10(y_high / y_low) > 1 ? log10(y_high / y_low) : 1
    set logscale y
    set format y '10^{%T}'
    set yrange [y_low * 10 ** (-0.15 * decades) : y_high * 10 ** ((lost_runs ? 0.25 : 0.1) * decades)]
} else {
    set yrange [-1:1] # every value is 0, or there is none
    if (lost_runs < runs) { set ytics ('0' 0) } else { unset ytics }
}
set y2range [0:1]
set xlabel x_name noenhanced
set ylabel (y_name eq 'energy_drift' ? '|energy_drift|' : y_name) noenhanced
if (x_tics ne '') { eval 'set xtics ('.x_tics.') noenhanced' }
if (!numeric) { # cases beside one another, not along a line
    set xtics rotate by -20
    set xlabel ''
}
set key below maxcols 1 noenhanced
set label 1 'Sweep of '.problem.': '.y_name.' over '.x_name at graph 0, graph 1.06 noenhanced \
    font 'DejaVu Sans Bold,'.(fmt eq 'png' ? 18 : 12)

fits(k) = !numeric ? '' : strlen(ORDER[k]) \
    ? (x_name eq 'cells' ? ', order ' : ', slope ').minus(sprintf('%.2f', real(ORDER[k]))) : ': no '.(x_name eq 'cells' ? 'order' : 'slope')
because(k) = numeric && strlen(REASON[k]) ? ' ('.REASON[k].')' : ''
lost_of(k) = LOST[k] ? sprintf(', %d of %d lost', LOST[k], RUNS[k]) : ''
says(k) = LOST[k] == RUNS[k] ? TITLE[k].': every run is lost' : TITLE[k].lost_of(k).fits(k).because(k)
of(k) = int(column('series')) == k - 1
good(k) = of(k) && (strcol('status') eq 'ok' || strcol('status') eq 'energy_growth')
shown(k) = good(k) && (!y_log || abs(column(3)) > 0) ? abs(column(3)) : NaN
zero(k) = good(k) && y_log && strlen(strcol(3)) && !(abs(column(3)) > 0) ? 0.025 : NaN
dead(k) = of(k) && !good(k) ? 0.975 - 0.03 * ((k - 1) % 8) : NaN
# A curve has its method's colour and label; curves of one method differ in their dashes.
array OWN[curves]
array NTH[curves]
do for [k = 1:curves] {
    OWN[k] = ''
    NTH[k] = 1
    do for [w in ALL] {
        if (TITLE[k] eq w || substr(TITLE[k], 1, strlen(w) + 1) eq w.';') {
            OWN[k] = w
            TITLE[k] = label(w).substr(TITLE[k], strlen(w) + 1, strlen(TITLE[k]))
            break
        }
    }
    do for [j = 1:k - 1] { if (OWN[j] eq OWN[k]) { NTH[k] = NTH[k] + 1 } }
}
style_(k) = strlen(OWN[k]) ? style(OWN[k]) : slot(1 + (k - 1) % 10)
dash_(k) = strlen(OWN[k]) ? NTH[k] : 1 + (k - 1) / 10
zeros = 0
stats curves_ using (zeros = zeros + (sum [k = 1:curves] (zero(k) > 0)), 1) nooutput
line(k) = numeric ? shown(k) : NaN
plot for [k = 1:curves] curves_ using 2:(line(k)) with lines ls style_(k) dt dash_(k) notitle, \
     for [k = 1:curves] curves_ using 2:(shown(k)) with points ls style_(k) notitle, \
     for [k = 1:curves] curves_ using 2:(zero(k)) axes x1y2 with points pt 6 ps 1.2 lc rgb COLOUR[style_(k)] notitle, \
     for [k = 1:curves] curves_ using 2:(dead(k)) axes x1y2 with points pt 2 ps 1.2 lw 2 lc rgb COLOUR[style_(k)] notitle, \
     for [k = 1:curves] keyentry with linespoints ls style_(k) dt dash_(k) title says(k), \
     keyentry with points pt 2 ps 1.2 lw 2 lc rgb '#444444' title (lost_runs ? 'lost' : ''), \
     keyentry with points pt 6 ps 1.2 lc rgb '#444444' title (zeros ? 'exactly 0' : '')
