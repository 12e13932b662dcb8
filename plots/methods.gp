# methods.gp: sets seen_, the methods in table list_ in order of appearance, and at_(method), their index from 0.
seen_ = ''
add_(m) = strstrt(' '.seen_.' ', ' '.m.' ') ? 0 : (seen_ = seen_.' '.m, 0)
set datafile columnheaders # the first line is none of them
stats list_ using (add_(strcol('method'))) nooutput
unset datafile columnheaders
at_(m) = sum [k = 1:words(seen_)] (word(seen_, k) eq m ? k - 1 : 0)
