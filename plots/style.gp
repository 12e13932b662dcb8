# style.gp: what all figures share. The caller sets fmt (svg, png), out, dir, name, csv and plots; a script
# may set `tall` (height over the usual) before it loads this.
if (!exists('tall')) tall = 1
set encoding utf8
if (fmt eq 'png') {
    set terminal pngcairo size 1400,int(950 * tall) font 'DejaVu Sans,18' enhanced linewidth 1.4 background '#ffffff'
} else {
    set terminal svg size 720,int(490 * tall) dynamic font 'DejaVu Sans,12' enhanced name name background '#ffffff'
}
set output out
set datafile separator ','

# One colour (Okabe and Ito, then Tol's muted ones, told apart by colour-blind readers, too) and one
# marker a method, the same in every figure: use `ls style('gimp')`. A method that is not listed
# here is drawn by what follows FEM; `load plots.'/methods.gp'` first finds it in the table.
METHODS = 'mpm gimp ge_mpm ge_gimp wls wls2 ge_wls bspline apic tpic xpic fmpm fem'
LABELS = 'MPM GIMP GE-MPM GE-GIMP WLS WLS2 GE-WLS B-spline APIC TPIC XPIC FMPM FEM'
array COLOUR[18] = ['#D55E00', '#0072B2', '#E69F00', '#56B4E9', '#009E73', '#CC79A7', '#8C6D00', \
                    '#332288', '#882255', '#CC6677', '#44AA99', '#999933', '#000000', '#7A5195', \
                    '#999999', '#117733', '#661100', '#6699CC']
array MARKER[18] = [4, 7, 6, 5, 9, 11, 13, 15, 12, 8, 10, 14, 2, 3, 12, 6, 4, 8]
do for [k = 1:18] {
    set style line k lc rgb COLOUR[k] lw 1.6 pt MARKER[k] ps 0.8
}
EVERY = METHODS # and what methods.gp adds
place(m) = sum [k = 1:words(EVERY)] (word(EVERY, k) eq m ? k : 0)
style(m) = place(m) < 1 || place(m) > 18 ? 18 : place(m)
label(m) = place(m) > 0 && place(m) <= words(LABELS) ? word(LABELS, place(m)) : m

# Rows of one method: `using (only('gimp', 'ppc')):'error_linf'` has no points of the others.
only(m, column_name) = strcol('method') eq m ? column(column_name) : NaN

set border 3 lw 1 lc rgb '#444444'
set tics nomirror out scale 0.6,0.3 textcolor rgb '#333333'
set grid xtics ytics lt 1 dt 1 lw 0.7 lc rgb '#e3e3e3'
set key textcolor rgb '#222222' samplen 2.4 spacing 1.2 Left reverse
set style line 20 lc rgb '#666666' lw 1.2 dt 1 # guides
set style line 21 lc rgb '#666666' lw 1.2 dt 2
set style line 22 lc rgb '#334155' pt 7 ps 0.7 # particles where no method matters
set minussign
minus(s) = strstrt(s, '-') == 1 ? '−'.s[2:] : s # the sign of a number that sprintf wrote
set tmargin 3
heading(s) = '{/:Bold '.s.'}' # set label 1 heading('...') at graph 0, graph 1.06
