// The files that the module of WebAssembly reads and writes, in memory: the calls of WASI (preview 1) that wasi-libc makes
// for them. Folders are there while a file is in them.

const errno = {ok: 0, badDescriptor: 8, isFolder: 31, notFound: 44};
const filetype = {folder: 3, file: 4};
const root = 3; // the first number of a file; 0 to 2 are the standard streams
const oflags = {create: 1, truncate: 8};

/** Bytes that grow: to twice their room each time, as a file is written in many small parts. */
class MemoryFile {
  constructor(bytes = new Uint8Array(0)) {
    this.room = bytes;
    this.size = bytes.length;
  }

  bytes() {
    return this.room.subarray(0, this.size);
  }

  write(bytes, at) {
    const end = at + bytes.length;
    if (end > this.room.length) {
      const larger = new Uint8Array(Math.max(end, 2 * this.room.length));
      larger.set(this.bytes());
      this.room = larger;
    }
    this.room.set(bytes, at);
    this.size = Math.max(this.size, end);
  }
}

/** "a/b.ply", of "/a/./b.ply" */
function normal(name) {
  const parts = [];
  for (const part of name.split('/')) {
    if (part === '..') parts.pop();
    else if (part !== '' && part !== '.') parts.push(part);
  }
  return parts.join('/');
}

export class MemoryFiles {
  /** \param memory gives the module's memory */
  constructor(memory) {
    this.memory = memory;
    this.files = new Map(); // by normal names
    this.open = new Map([[root, {name: ''}]]); // {name, file, at} by descriptors; folders have no file
    this.next = root + 1;
  }

  set(name, bytes) {
    this.files.set(normal(name), new MemoryFile(bytes));
  }

  /** Takes out all files of a folder. \return [{name, bytes}] */
  take(folder) {
    const taken = [];
    for (const [name, file] of this.files) {
      if (!name.startsWith(`${folder}/`)) continue;
      taken.push({name: name.slice(folder.length + 1), bytes: file.bytes().slice()});
      this.files.delete(name);
    }
    return taken;
  }

  isFolder(name) {
    return name === '' || [...this.files.keys()].some((other) => other.startsWith(`${name}/`));
  }

  /** What WASI calls. */
  imports() {
    const view = () => new DataView(this.memory().buffer);
    const nameAt = (at, length) => normal(new TextDecoder().decode(new Uint8Array(this.memory().buffer, at, length).slice()));
    return {
      fd_prestat_get: (descriptor, to) => this.tellRoot(descriptor, view(), to),
      fd_prestat_dir_name: (descriptor, to) => {
        view().setUint8(to, '/'.charCodeAt(0));
        return errno.ok;
      },
      fd_fdstat_get: (descriptor, to) => this.tellKind(descriptor, view(), to),
      fd_fdstat_set_flags: () => errno.ok,
      fd_filestat_get: (descriptor, to) => {
        const one = this.open.get(descriptor);
        return one ? this.tellStatus(one.file, view(), to) : errno.badDescriptor;
      },
      path_filestat_get: (folder, flags, at, length, to) => {
        const name = nameAt(at, length);
        const file = this.files.get(name);
        return file || this.isFolder(name) ? this.tellStatus(file, view(), to) : errno.notFound;
      },
      path_open: (folder, links, at, length, how, rights, inherited, flags, to) => this.openFile(nameAt(at, length), how, view(), to),
      path_rename: (folder, at, length, otherFolder, otherAt, otherLength) => this.rename(nameAt(at, length), nameAt(otherAt, otherLength)),
      path_unlink_file: (folder, at, length) => this.files.delete(nameAt(at, length)) ? errno.ok : errno.notFound,
      fd_close: (descriptor) => this.open.delete(descriptor) ? errno.ok : errno.badDescriptor,
      fd_read: (descriptor, parts, n, to) => this.transfer(descriptor, parts, n, view(), to, (one, bytes) => {
        const some = one.file.bytes().subarray(one.at, one.at + bytes.length);
        bytes.set(some);
        return some.length;
      }),
      fd_write: (descriptor, parts, n, to) => this.transfer(descriptor, parts, n, view(), to, (one, bytes) => {
        one.file.write(bytes, one.at);
        return bytes.length;
      }),
      fd_seek: (descriptor, offset, from, to) => this.seek(descriptor, Number(offset), from, view(), to),
    };
  }

  tellRoot(descriptor, view, to) {
    if (descriptor !== root) return errno.badDescriptor;
    view.setUint8(to, 0); // a folder
    view.setUint32(to + 4, 1, true); // the length of its name
    return errno.ok;
  }

  tellKind(descriptor, view, to) {
    const one = this.open.get(descriptor);
    if (!one) return errno.badDescriptor;
    view.setUint8(to, one.file ? filetype.file : filetype.folder);
    view.setUint16(to + 2, 0, true);
    view.setBigUint64(to + 8, ~0n, true); // all rights
    view.setBigUint64(to + 16, ~0n, true);
    return errno.ok;
  }

  /** \param file undefined: a folder */
  tellStatus(file, view, to) {
    new Uint8Array(view.buffer, to, 64).fill(0);
    view.setUint8(to + 16, file ? filetype.file : filetype.folder);
    view.setBigUint64(to + 24, 1n, true);
    view.setBigUint64(to + 32, BigInt(file?.size ?? 0), true);
    return errno.ok;
  }

  openFile(name, how, view, to) {
    let file = this.files.get(name);
    if (!file && !(how & oflags.create) && !this.isFolder(name)) return errno.notFound;
    if (how & oflags.truncate || !file && how & oflags.create) {
      if (!file && this.isFolder(name)) return errno.isFolder;
      file = new MemoryFile();
      this.files.set(name, file);
    }
    this.open.set(this.next, {name, file, at: 0});
    view.setUint32(to, this.next++, true);
    return errno.ok;
  }

  rename(from, to) {
    const file = this.files.get(from);
    if (!file) return errno.notFound;
    this.files.delete(from);
    this.files.set(to, file);
    return errno.ok;
  }

  /** Reads or writes parts of the memory, one after the other. */
  transfer(descriptor, parts, n, view, to, move) {
    const one = this.open.get(descriptor);
    if (!one?.file) return errno.badDescriptor;
    let sum = 0;
    for (let i = 0; i < n; ++i) {
      const bytes = new Uint8Array(view.buffer, view.getUint32(parts + 8 * i, true), view.getUint32(parts + 8 * i + 4, true));
      const moved = move(one, bytes);
      one.at += moved;
      sum += moved;
      if (moved < bytes.length) break;
    }
    view.setUint32(to, sum, true);
    return errno.ok;
  }

  seek(descriptor, offset, from, view, to) {
    const one = this.open.get(descriptor);
    if (!one?.file) return errno.badDescriptor;
    one.at = offset + [0, one.at, one.file.size][from];
    view.setBigUint64(to, BigInt(one.at), true);
    return errno.ok;
  }
}
