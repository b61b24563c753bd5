"""Errors of simulations against the time that they take."""
