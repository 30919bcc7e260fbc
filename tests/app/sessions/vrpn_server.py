"""A VRPN server of one device, which does with names and pings as vrpn_server does."""

import socket
import struct
import threading

TYPES = ["vrpn_Tracker Pos_Quat", "vrpn_Button Change", "vrpn_Base ping_message", "vrpn_Base pong_message"]


def record(sender, kind, payload=b"", at_s=0.0):
    head = struct.pack(">IIIiiI", 24 + len(payload), int(at_s), int(at_s % 1 * 1e6), sender, kind, 0)
    return head + payload + bytes(-len(payload) % 8)


def named(number, kind, name):
    text = name.encode() + b"\0"
    return record(number, kind, struct.pack(">I", len(text)) + text)


class Server:
    """One device of that name. Every name that a client names is kept and named back, to later clients too."""

    def __init__(self, device):
        self.names = ["VRPN Control", device]
        self.clients = []
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        while True:
            client, _ = self.listener.accept()
            threading.Thread(target=self.meet, args=(client,), daemon=True).start()

    def meet(self, client):
        client.sendall(b"vrpn: ver. 07.35  0".ljust(24, b"\0"))
        reader = client.makefile("rb")
        if len(reader.read(24)) < 24:
            return
        described = [named(i, -1, name) for i, name in enumerate(self.names)]
        client.sendall(b"".join(described + [named(i, -2, name) for i, name in enumerate(TYPES)]))
        self.clients.append(client)
        theirs = {}
        while len(head := reader.read(24)) == 24:
            length, _, _, sender, kind, _ = struct.unpack(">IIIiiI", head)
            payload = reader.read((length + 7) // 8 * 8 - 24)
            if kind == -1:
                theirs[sender] = name = payload[4 : length - 25].decode()
                if name not in self.names:
                    self.names.append(name)
                    client.sendall(named(len(self.names) - 1, -1, name))
            elif kind == 0 and theirs.get(sender) == self.names[1]:
                client.sendall(record(1, 3))

    def send(self, kind, payload, at_s):
        for client in self.clients:
            try:
                client.sendall(record(1, kind, payload, at_s))
            except OSError:
                self.clients.remove(client)
