"""What serves every room and knows nothing of robots: limits of time, progress, futures, files
written whole.
"""
