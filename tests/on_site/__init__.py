"""The course as a site, which is built once for all files."""
