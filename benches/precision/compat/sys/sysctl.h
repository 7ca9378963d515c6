/* Gone from the C library, and still included by a file of Chipmunk 7.0.0 that does not use it here. */
