# viridis.gp: the palette of fields.
set palette defined (0 '#440154', 1 '#472c7a', 2 '#3b518b', 3 '#2c718e', 4 '#21908d', 5 '#27ad81', 6 '#5cc863', \
                     7 '#aadc32', 8 '#fde725')
