"""Code that the exercises of several lessons share."""
