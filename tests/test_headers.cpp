// Holds the precompiled header of all tests.
