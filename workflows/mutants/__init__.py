"""Mutation testing of the rooms that carry the numbers: `make test-mutants`.

A mutation is one small change of the source that a test ought to notice. Nothing on disk is
changed: a forked process imports the changed module and runs the tests that reach the changed
line, fastest first, until one fails. See docs/decisions/0016-mutants-of-our-own.md.
"""
