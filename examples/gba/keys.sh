# The keys of the game that is measured: pictures, and the keys held from there on.
keys='200 130:right 20:right+a 60:right 20:left+a 100:left 20:left+a 100:left 100:right 20:right+a 80:right 10:start'
