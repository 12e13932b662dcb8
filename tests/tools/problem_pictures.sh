#!/usr/bin/env bash
# problem_pictures.sh PROGRAM FOLDER: draws plots/readme_problems.png, one small picture per problem, as README shows them: particles at a
# telling time, coloured by von Mises stress (of a projection: by velocity); in 1D the velocity along the bar. In 3D
# what is seen from above z. A line below gives the run of each.
set -eu
program=$(realpath "$1")
plots=$(realpath "$(dirname "$0")/../../plots")
mkdir -p "$2" && cd "$2"
runs='squeeze --cells 8 --ppc 2.5
bar --cells 40 --t-end .017
sine_bar --cells 40 --t-end .004
column --cells 30 --t-end .02
pulled_bar --cells 40 --t-end .008
patch --cells 8
block --cells 12 --method apic --set dim=2 --set spin=6 --t-end .1
free_block --cells 24 --set dim=2 --t-end .1
plate_vibration --cells 24 --set A=.05
axis_mms --cells 24 --t-end .006
ring --cells 40 --method wls2 --t-end .006
vortex --cells 32 --method apic --t-end .5 --set G=.5 --set layout=radial --cfl .1
disk_impact --cells 40 --method wls2 --t-end 1.2
hole_plate --cells 40 --method wls2
cantilever --cells 4 --method wls2
hanging_bar --cells 8 --method tlmpm --t-end .2
collinear_bars --cells 40 --t-end .01
sliding_block --cells 10
two_disks --cells 40 --t-end .9
scan --cells 40 --set load=squeeze
shell --cells 12 --method wls2 --t-end .006
ball_impact --cells 20 --t-end 1.2
cavity --cells 20 --method wls2'
while read -r problem options; do
    # shellcheck disable=SC2086
    "$program" run "$problem" $options --particles "$problem.csv" --quiet >row || { echo "problem_pictures: $problem: $(tail -n 1 row)" >&2 && exit 1; }
done <<<"$runs"
cat >draw.gp <<'G'
set terminal pngcairo size 1100,1100 font 'DejaVu Sans,11' background '#ffffff'
set output plots.'/readme_problems.png'
load plots.'/viridis.gp'
set datafile separator ',' columnheaders
set multiplot layout 5, 5 margins 0.01, 0.99, 0.01, 0.965 spacing 0.015, 0.045
unset border; unset tics; unset key; unset colorbox
do for [k = 1:words(names)] {
    file = word(names, k).'.csv'
    set title word(names, k) noenhanced font 'DejaVu Sans Bold,11' offset 0,-0.6
    set autoscale
    stats file using 0 nooutput
    stats file using (strlen(strcol('y')) ? column('y') : 0) name 'Y' nooutput
    plane = Y_max > Y_min
    if (plane) {
        set size ratio -1
        set offsets graph 0.03, graph 0.03, graph 0.03, graph 0.03
        plot file using 'x':'y':'von_mises' with points pt 7 ps (STATS_records > 4000 ? 0.2 : 0.35) palette
    } else {
        set size noratio
        set offsets graph 0.05, graph 0.05, graph 0.3, graph 0.3
        plot file using 'x':'vx' with linespoints pt 7 ps 0.5 lc rgb '#2c718e'
    }
}
unset multiplot
G
gnuplot -e "names='$(sed 's/ .*//' <<<"$runs" | tr '\n' ' ')'; plots='$plots'" draw.gp
