# hard.gp: for the hard cases: seen_ are the methods of table list_ in its order, along an axis by at_(method).
seen_ = ''
add_(m) = m eq 'method' || strstrt(' '.seen_.' ', ' '.m.' ') ? 0 : (seen_ = seen_.' '.m, 0)
stats list_ using (add_(strcol('method'))) nooutput
at_(m) = sum [k = 1:words(seen_)] (word(seen_, k) eq m ? k - 1 : 0)
EVERY = METHODS
do for [m in seen_] { if (strstrt(' '.EVERY.' ', ' '.m.' ') == 0) { EVERY = EVERY.' '.m } }
array SHADE[4] = ['#0072B2', '#009E73', '#D55E00', '#CC79A7'] # of variants of one method
