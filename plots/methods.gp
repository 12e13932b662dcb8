# methods.gp: EVERY = the methods of style.gp and whatever others the table has, in its order.
note(m) = strstrt(' '.EVERY.' ', ' '.m.' ') == 0 ? (EVERY = EVERY.' '.m, 0) : 0
stats csv using (note(strcol('method'))) nooutput
