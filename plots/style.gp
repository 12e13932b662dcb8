# style.gp: what all figures share. The caller sets fmt (svg, png, page.png), out, dir, name, csv and plots; a script
# may set `tall` (height over the usual) before it loads this.
if (!exists('tall')) tall = 1
set encoding utf8
if (fmt eq 'png') {
    set terminal pngcairo size 1400,int(950 * tall) font 'DejaVu Sans,18' enhanced linewidth 1.4 background '#ffffff'
} else { if (fmt eq 'page.png') { # in the pixels that the page shows
    set terminal pngcairo size 800,int(543 * tall) font 'DejaVu Sans,10.3' enhanced background '#ffffff'
} else {
    set terminal svg size 933,int(633 * tall) dynamic font 'DejaVu Sans,12' enhanced name name background '#ffffff'
}}
set output out
set datafile separator ','

# One label, colour and marker per method, the same in every figure: use `ls style('gimp')`, label('gimp') and
# COLOUR[style('gimp')]. The program hands over METHODS and REQUESTED (methods that studies run on request),
# and for both LABELS, COLOURS and MARKERS (studies/engine/palette.c); a method that is not among them is drawn in grey.
if (!exists('METHODS')) { METHODS = ''; REQUESTED = ''; LABELS = ''; COLOURS = ''; MARKERS = '' }
ALL = METHODS.' '.REQUESTED
place(m) = sum [k = 1:words(ALL)] (word(ALL, k) eq m ? k : 0)
slot(k) = k < 20 ? k : k + 10 # line styles 20 to 29 are not methods'
OTHER = slot(words(ALL) + 1)
array COLOUR[OTHER]
do for [k = 1:words(ALL)] {
    COLOUR[slot(k)] = word(COLOURS, k)
    set style line slot(k) lc rgb word(COLOURS, k) lw 1.6 pt int(word(MARKERS, k)) ps 0.8
}
COLOUR[OTHER] = '#999999'
set style line OTHER lc rgb '#999999' lw 1.6 pt 8 ps 0.8
style(m) = place(m) ? slot(place(m)) : OTHER
plain(s) = strstrt(s, '_') ? s[1:strstrt(s, '_') - 1].'\_'.plain(s[strstrt(s, '_') + 1:]) : s # no subscripts
label(m) = place(m) ? word(LABELS, place(m)) : plain(m)

# Rows of one method: `using (only('gimp', 'ppc')):'error_linf'` has no points of the others.
only(m, column_name) = strcol('method') eq m ? column(column_name) : NaN

set border 3 lw 1 lc rgb '#444444'
set tics nomirror out scale 0.6,0.3 textcolor rgb '#333333'
set grid xtics ytics lt 1 dt 1 lw 0.7 lc rgb '#e3e3e3'
set key textcolor rgb '#222222' samplen 2.4 spacing 1.2 Left reverse
set style line 20 lc rgb '#666666' lw 1.2 dt 1 # guides
set style line 21 lc rgb '#666666' lw 1.2 dt 2
set style line 22 lc rgb '#334155' pt 7 ps 0.7 # particles where no method matters
array VARIANT[5] = ['#334155', '#0e7490', '#b45309', '#a855f7', '#65a30d'] # of variants, which are no methods
set minussign
set format '%h' # the default '% h' leaves room for a sign
minus(s) = strstrt(s, '-') == 1 ? '−'.s[2:] : s # the sign of a number that sprintf wrote
set tmargin 3
heading(s) = '{/:Bold '.s.'}' # set label 1 heading('...') at graph 0, graph 1.06
