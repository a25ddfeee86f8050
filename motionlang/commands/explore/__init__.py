"""`motionlang explore`: the states and transitions of the machine of a program."""
