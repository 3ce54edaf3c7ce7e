let most = 32
