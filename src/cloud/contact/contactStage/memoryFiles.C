/*---------------------------------------------------------------------------*\
    cghsFoam | coarse-grained hard spheres in OpenFOAM
    GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "memoryFiles.H"
#include "labelFieldIOField.H"
#include "scalarFieldIOField.H"
#include "PstreamReduceOps.H"
#include "Time.H"

namespace Foam
{
namespace cghs
{

//- Numbers that make up a memory
constexpr label nNumbers = 8;


static IOobject memoryIO
(
    const objectRegistry& cloud,
    const word& name,
    const IOobject::readOption read
)
{
    return IOobject
    (
        name,
        cloud.time().timeName(),
        cloud,
        read,
        IOobject::NO_WRITE,
        false
    );
}


//- The lists of a file, one a parcel; none if no rank with parcels has the file
template<class FileType>
static List<typename FileType::value_type> readLists
(
    const objectRegistry& cloud,
    const word& name,
    const label n
)
{
    // As text it has another class than in binary
    const bool there =
        memoryIO(cloud, name, IOobject::MUST_READ)
       .typeHeaderOk<FileType>(false);

    if (!returnReduce(there && n > 0, orOp<bool>()))
    {
        return List<typename FileType::value_type>();
    }

    const FileType file(memoryIO(cloud, name, IOobject::MUST_READ), n > 0);

    if (file.size() != n)
    {
        FatalIOError("readMemories", __FILE__, __LINE__, file.objectPath())
            << file.size() << " lists for " << n << " parcels" << nl
            << "Restore the file, or remove " << name << ": contacts then begin"
            << " without memory" << nl
            << exit(FatalIOError);
    }

    return file;
}


static void append(scalarField& to, label& k, const vector& v)
{
    for (const scalar c : v)
    {
        to[k++] = c;
    }
}


static scalarField numbersOf(const memoryTransfer::remembered& r)
{
    scalarField numbers(nNumbers);
    label k = 0;

    append(numbers, k, r.n);
    numbers[k++] = r.memory.load;
    numbers[k++] = r.memory.held;
    append(numbers, k, r.memory.rubbing);

    return numbers;
}


//- Stop if the memories of parcel i are not whole
static void checkNumbers
(
    const objectRegistry& cloud,
    const label i,
    const labelUList& partners,
    const UList<scalar>& numbers
)
{
    bool whole = numbers.size() == nNumbers*partners.size();

    for (const scalar x : numbers)
    {
        whole = whole && mag(x) < GREAT;
    }

    if (!whole)
    {
        FatalIOError
        (
            "readMemories",
            __FILE__,
            __LINE__,
            memoryIO(cloud, "contactMemories", IOobject::NO_READ).objectPath()
        )
            << "Parcel " << i << " has " << numbers.size() << " numbers for "
            << partners.size() << " contacts, or one that is none; it must have "
            << nNumbers << " for each" << nl
            << "Restore the file, or remove it and contactPartners: contacts then"
            << " begin without memory" << nl
            << exit(FatalIOError);
    }
}


static memoryTransfer::remembered remember
(
    const label idA,
    const label idB,
    const scalar* x
)
{
    memoryTransfer::remembered r;

    r.idA = idA;
    r.idB = idB;
    r.n = vector(x[0], x[1], x[2]);
    r.memory.load = x[3];
    r.memory.held = x[4];
    r.memory.rubbing = vector(x[5], x[6], x[7]);

    return r;
}

} // End namespace cghs
} // End namespace Foam


void Foam::cghs::readMemories
(
    const objectRegistry& cloud,
    const arena& parcels,
    contactStage& contacts
)
{
    const label n = parcels.size();
    const List<labelField> partners
    (
        readLists<labelFieldCompactIOField>(cloud, "contactPartners", n)
    );
    const List<scalarField> memories
    (
        readLists<scalarFieldCompactIOField>(cloud, "contactMemories", n)
    );

    // On all ranks alike: those without parcels have neither
    if (partners.empty() != memories.empty() || (n && partners.empty()))
    {
        WarningInFunction
            << "Contacts of cloud " << cloud.name() << " begin without memory:"
            << " contactPartners or contactMemories are missing in "
            << memoryIO(cloud, "contactPartners", IOobject::NO_READ).path() << nl
            << endl;
        return;
    }

    forAll(partners, i)
    {
        checkNumbers(cloud, i, partners[i], memories[i]);

        forAll(partners[i], k)
        {
            contacts.adopt
            (
                remember
                (
                    parcels.ids[i],
                    partners[i][k],
                    &memories[i][k*nNumbers]
                )
            );
        }
    }
}


void Foam::cghs::writeMemories
(
    const objectRegistry& cloud,
    const arena& parcels,
    const contactStage& contacts,
    IOstream::versionNumber ver,
    IOstream::compressionType cmp
)
{
    const label n = parcels.size();

    labelFieldCompactIOField partners
    (
        memoryIO(cloud, "contactPartners", IOobject::NO_READ), n
    );
    scalarFieldCompactIOField memories
    (
        memoryIO(cloud, "contactMemories", IOobject::NO_READ), n
    );

    contacts.visitMemories
    (
        parcels,
        [&](const label i, const memoryTransfer::remembered& r)
        {
            partners[i].append(r.idB);
            memories[i].append(numbersOf(r));
        }
    );

    // reconstructPar passes over lists that are written as text
    partners.writeObject(IOstream::BINARY, ver, cmp, n > 0);
    memories.writeObject(IOstream::BINARY, ver, cmp, n > 0);
}
